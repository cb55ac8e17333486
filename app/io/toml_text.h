// Text of TOML values.
#pragma once

#include <string>
#include <string_view>

namespace pupflow::io {

/// A string on one line. `text` must be UTF-8.
std::string toml_string(std::string_view text);

/// A finite number in its shortest form that TOML reads back to the same.
std::string toml_number(double value);

}  // namespace pupflow::io
