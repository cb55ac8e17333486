#include "app/io/text.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>

namespace pupflow::io {

namespace {

/// How many bytes of `text` from `at` on are one character that a terminal may show; 0 for none.
std::size_t shown_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const unsigned first = byte(at);
  if (first < 0x80) return first < 0x20 || first == 0x7f ? 0 : 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  const bool overlong =
      (first == 0xe0 && byte(at + 1) < 0xa0) || (first == 0xf0 && byte(at + 1) < 0x90);
  const bool control = first == 0xc2 && byte(at + 1) < 0xa0;  // U+0080 ... U+009F
  if (first < 0xc2 || first > 0xf4 || overlong || control) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return 0;
  }
  return length;
}

}  // namespace

std::string printable(std::string_view text, std::string_view kept) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const bool as_it_is = kept.find(text[at]) != std::string_view::npos;
    const std::size_t length = as_it_is ? 1 : shown_length(text, at);
    if (length == 0) {
      result += formatted("\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(text[at])));
    } else {
      result += text.substr(at, length);
    }
    at += std::max<std::size_t>(length, 1);
  }
  return result;
}

std::string quoted(std::string_view text) {
  std::string result(1, '\'');
  result += printable(text);
  result += '\'';
  return result;
}

std::string number_text(double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string hash_text(std::uint64_t hash) {
  return formatted("%016llx", static_cast<unsigned long long>(hash));
}

std::optional<std::uint64_t> read_hash(std::string_view text) {
  std::uint64_t hash = 0;
  std::from_chars(text.data(), text.data() + text.size(), hash, 16);
  return hash_text(hash) == text ? std::optional(hash) : std::nullopt;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::string formatted(const char* pattern, ...) {
  char text[256];
  std::va_list values;
  va_start(values, pattern);
  std::vsnprintf(text, sizeof text, pattern, values);
  va_end(values);
  return text;
}

}  // namespace pupflow::io
