// The model's temperatures on a thermometer. Files, parameters and options have model units.
#pragma once

#include <string>

#include "app/io/text.h"

namespace pupflow::io {

/// 0.6, the paper's preferred temperature, stands for 37 degrees (docs/model.md).
constexpr double kCelsiusPerUnit = 37 / 0.6;

constexpr double celsius(double temperature) {
  return kCelsiusPerUnit * temperature;
}

inline std::string celsius_text(double temperature) {
  return formatted("%.1f \u00b0C", celsius(temperature));
}

/// "0.4 (24.7 °C)", where `shown` is the temperature as it is written, and `degrees` says whether
/// degrees follow.
inline std::string with_celsius(const std::string& shown, double temperature, bool degrees) {
  return degrees ? shown + " (" + celsius_text(temperature) + ")" : shown;
}

/// Whether a row of parameters(), observables(), pup_fields() or afferent_fields() is a temperature:
/// its symbol is a T with an index.
template <class Row>
bool is_temperature(const Row& row) {
  return row.symbol.starts_with("T_");
}

}  // namespace pupflow::io
