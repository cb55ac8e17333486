#include "app/io/toml_problem.h"

#include <algorithm>
#include <array>

namespace pupflow::io {
namespace {

/// What stands in a description of toml++, and what it means. The first that fits counts.
struct Words {
  std::string_view of_library, own;
};
constexpr std::array kWords{
    Words{"expected '='", "a '=' is missing after the name"},
    Words{"cannot redefine", "this name is given twice"},
    Words{"comment or whitespace", "more follows on the line; a text needs quotes"},
    Words{"expected value,", "a value is missing"},
    Words{"value type", "is no value; a text needs quotes"},
    Words{"leading zero", "a number must not begin with 0 and more digits"},
    Words{"not representable", "the number is too large"},
    Words{"escape sequence", "in a text a single \\ is written \\\\"},
    Words{"control characters", "a text must end on its line, with a quote"},
    Words{"utf-8", "is no UTF-8 text"},
    Words{"comma or closing", "a list lacks a ',' or its ']'"},
    Words{"string: enc", "a text lacks its closing quote"},
    Words{"array: enc", "a list lacks its ']'"},
    Words{"inline table", "is no table; it must be {name = value, ...}"},
    Words{"table header",
          "is no heading of a table; it must be [name] or [[name]] on its own line"},
    Words{"boolean", "must be true or false"},
    Words{"integer", "is no number"},
    Words{"floating-point", "is no number; write e.g. 0.5"},
    Words{"date", "is no date"},
    Words{"time", "is no time"},
    Words{"value: enc", "a value is missing"},
    Words{"pair: enc", "a value is missing"},
};

}  // namespace

std::string toml_problem(std::string_view description) {
  const auto* words = std::ranges::find_if(kWords, [&](const Words& row) {
    return description.find(row.of_library) != std::string_view::npos;
  });
  return std::string(words != kWords.end() ? words->own
                                           : "is no TOML; a line is name = value, e.g. ta = 0.2");
}

}  // namespace pupflow::io
