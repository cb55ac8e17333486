// What varies in a sweep, as it is typed: --vary.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pupflow/parameters.h"

namespace pupflow::study {

/// The most values of one parameter, and rows of a table.
constexpr std::int64_t kMostValues = 1'000'000;

/// One varied parameter and its values.
struct Axis {
  const Parameter* parameter;
  std::vector<double> values;
};

/// The parameter called `name`, in a message that begins with `where`. Throws io::Failure(bad_input)
/// with the name that may have been meant.
const Parameter& parameter_named(const std::string& name, const std::string& where);

/// Reads "name=from:to:count" (evenly spaced, both ends included), "name=from:to:step=S" or
/// "name=a,b,c". Throws io::Failure(bad_input).
Axis parse_axis(const std::string& text);

/// What a parameter may be in a latin hypercube.
struct Span {
  Axis axis;
  bool between;  // anything between the two values; otherwise one of the values
};

/// Reads "name=from:to" or "name=a,b,c". Throws io::Failure(bad_input).
Span parse_span(const std::string& text);

/// "name=a,b,c", and for a span "name=from:to": the text that is read back to the same.
std::string axis_text(const Axis& axis, char separator = ',');
std::string span_text(const Span& span);

}  // namespace pupflow::study
