#include "app/io/toml_text.h"

#include <cmath>

#include "app/io/text.h"

namespace pupflow::io {

std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '\n') {
      result += "\\n";
      continue;
    }
    if (code < 0x20 || code == 0x7f) {
      result += formatted("\\u%04x", static_cast<unsigned>(code));
      continue;
    }
    if (letter == '"' || letter == '\\') result += '\\';
    result += letter;
  }
  return result + '"';
}

std::string toml_number(double value) {
  const std::string text = number_text(value);
  // Whole numbers of TOML have 64 bits, and no sign of zero.
  const bool whole = text.find_first_of(".e") == std::string::npos;
  const bool fits = std::abs(value) < 9e18 && !(value == 0 && std::signbit(value));
  return whole && !fits ? text + ".0" : text;
}

}  // namespace pupflow::io
