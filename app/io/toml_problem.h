// What is wrong with a text that is no TOML, in this program's words.
#pragma once

#include <string>
#include <string_view>

namespace pupflow::io {

/// The words for `description`, with which toml++ gave up.
std::string toml_problem(std::string_view description);

}  // namespace pupflow::io
