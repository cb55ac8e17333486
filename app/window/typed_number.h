// What somebody typed, as a number.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "pupflow/parameters.h"

namespace pupflow::window {

/// A number, or one line that says why the text is none or is not allowed.
using Typed = std::variant<double, std::string>;

/// Reads `text`: blanks around it do not count, and a comma is a decimal point.
Typed read_typed(std::string_view text);

/// The same for a value of `parameter`, which must be within its range. A whole number has no
/// comma: 1,000 may be meant as a thousand.
Typed read_typed(const Parameter& parameter, std::string_view text);

/// The same for a number called `name` from `low` to `high`.
Typed read_typed(std::string_view name, double low, double high, std::string_view text);

}  // namespace pupflow::window
