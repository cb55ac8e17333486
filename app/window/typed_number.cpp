#include "app/window/typed_number.h"

#include <algorithm>
#include <charconv>

#include "app/io/text.h"

namespace pupflow::window {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

Typed named(std::string_view name, std::string_view range, const Typed& typed) {
  if (std::holds_alternative<double>(typed)) return typed;
  return std::string(name) + ": " + std::get<std::string>(typed) + "; it takes " +
         std::string(range);
}

}  // namespace

Typed read_typed(std::string_view text) {
  text = trimmed(text);
  if (text.empty()) return "nothing was typed";
  std::string plain(text);
  if (plain.front() == '+') plain.erase(0, 1);
  if (std::count(plain.begin(), plain.end(), ',') > 1) {
    return io::quoted(text) + " has several commas, and a comma is a decimal point";
  }
  std::replace(plain.begin(), plain.end(), ',', '.');
  double value = 0;
  const char* const end = plain.data() + plain.size();
  const auto [stop, error] = std::from_chars(plain.data(), end, value);
  const bool finite_text = plain.find_first_of("nN") == plain.npos;  // neither inf nor nan
  if (stop != end || error == std::errc::invalid_argument || !finite_text) {
    return io::quoted(text) + " is no number";
  }
  if (error != std::errc{}) return io::quoted(text) + " is too large or too small for a number";
  return value;
}

Typed read_typed(const Parameter& parameter, std::string_view text) {
  if (parameter.kind == Parameter::Kind::integer && text.find(',') != text.npos) {
    return named(parameter.name, range_text(parameter), io::quoted(text) + " has a comma");
  }
  const Typed typed = read_typed(text);
  if (std::holds_alternative<std::string>(typed)) {
    return named(parameter.name, range_text(parameter), typed);
  }
  Problem problem;
  if (!check_value(parameter, std::get<double>(typed), problem)) return problem.message;
  return typed;
}

Typed read_typed(std::string_view name, double low, double high, std::string_view text) {
  const std::string range = io::number_text(low) + " \u2026 " + io::number_text(high);
  Typed typed = read_typed(text);
  if (const double* value = std::get_if<double>(&typed);
      value && !(*value >= low && *value <= high)) {
    typed = io::quoted(trimmed(text)) + " is out of range";
  }
  return named(name, range, typed);
}

}  // namespace pupflow::window
