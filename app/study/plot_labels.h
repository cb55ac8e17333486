// Words in the figures of a sweep, as gnuplot's enhanced text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/study/axis.h"
#include "pupflow/fields.h"

namespace pupflow::study {

/// `text` with its indices set low: "T_b(0)" becomes "T_{b}(0)".
std::string enhanced(std::string_view text);

/// A parameter's symbol and title, or an output's label, with the unit. Where there is no axis in °C,
/// `celsius` says what a temperature is on a thermometer.
std::string label(const Parameter& parameter, bool celsius = false);
std::string label(const Field& field, bool celsius = false);

/// Values of a parameter in so few digits, at least three, that all differ.
std::vector<std::string> short_values(const Parameter& parameter,
                                      const std::vector<double>& values);

}  // namespace pupflow::study
