// TOML whose keys have so many parts that its reader would run out of stack.
#pragma once

#include <string>
#include <string_view>

namespace pupflow::io {

/// Call it before toml::parse. Says what is wrong, "line:column: message", where a key of `text` has
/// more than 32 dotted parts; empty where none has. (toml++ bounds nested values itself, by 256.)
std::string too_deep(std::string_view text);

}  // namespace pupflow::io
