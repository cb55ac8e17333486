// Small pieces of text that messages and files share.
#pragma once

#include <string>
#include <string_view>

namespace pupflow::io {

/// `text` between single quotes.
std::string quoted(std::string_view text);

/// A number in the shortest form that reads back to the same value; "nan" and "inf" where it is not
/// finite.
std::string number_text(double value);

/// What printf would print; at most 255 bytes.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* pattern, ...);

}  // namespace pupflow::io
