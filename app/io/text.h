// Small pieces of text that messages and files share.
#pragma once

#include <charconv>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pupflow::io {

/// `text` as a terminal may show it: control characters (of C0, C1) and bytes that are no UTF-8 as
/// \xNN, those in `kept` as they are.
std::string printable(std::string_view text, std::string_view kept = {});

/// `text` between single quotes, printable.
std::string quoted(std::string_view text);

/// A number in the shortest form that reads back to the same value; "nan" and "inf" where it is not
/// finite.
std::string number_text(double value);

/// `text` as a number, if that is all that it is: no blanks, no sign +.
template <class Number>
std::optional<Number> read_number(std::string_view text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

/// A hash or checksum as files hold it: 16 hexadecimal digits in small letters.
std::string hash_text(std::uint64_t hash);

/// What hash_text wrote; nothing where `text` is anything else.
std::optional<std::uint64_t> read_hash(std::string_view text);

/// The parts of `text` between separators: one more than there are separators.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The items with `separator` between them; `text(item)` is what is written of one.
template <class Range, class Text = std::identity>
std::string joined(const Range& items, std::string_view separator, Text text = {}) {
  std::string all;
  bool first = true;
  for (const auto& item : items) {
    if (!first) all += separator;
    all += text(item);
    first = false;
  }
  return all;
}

/// What printf would print; at most 255 bytes.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* pattern, ...);

}  // namespace pupflow::io
