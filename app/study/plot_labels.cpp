#include "app/study/plot_labels.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/io/celsius.h"
#include "app/io/text.h"

namespace pupflow::study {

std::string enhanced(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '_') {
      result += text[i];
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" ()", i), text.size());
    result += "_{" + std::string(text.substr(i + 1, end - i - 1)) + "}";
    i = end - 1;
  }
  return result;
}

namespace {

constexpr const char* kFactor = "0.6 is 37 \u00b0C";

}  // namespace

std::string label(const Parameter& parameter, bool celsius) {
  if (parameter.symbol.empty()) return std::string(parameter.title);
  std::string text = enhanced(parameter.symbol) + "  (" + std::string(parameter.title);
  if (!parameter.unit.empty()) text += ", " + std::string(parameter.unit);
  if (celsius && io::is_temperature(parameter)) text += ", " + std::string(kFactor);
  return text + ")";
}

std::string label(const Field& field, bool celsius) {
  std::string text = enhanced(field.label);
  if (celsius && io::is_temperature(field)) text += "  (" + std::string(kFactor) + ")";
  if (!field.unit.empty()) text += "  (" + std::string(field.unit) + ")";
  return text;
}

namespace {

/// With `digits` digits, or all those in front of the point of a number below a million.
std::string rounded(double value, int digits) {
  constexpr double kMillion = 1e6;
  for (double size = std::abs(value); size < kMillion && size >= std::pow(10, digits);) ++digits;
  return io::formatted("%.*g", digits, value);
}

}  // namespace

std::vector<std::string> short_values(const Parameter& parameter,
                                      const std::vector<double>& values) {
  std::vector<std::string> texts;
  const bool real = parameter.kind == Parameter::Kind::real;
  for (int digits = 3; digits <= 17; ++digits) {
    texts.clear();
    for (const double value : values)
      texts.push_back(real ? rounded(value, digits) : format_value(parameter, value));
    if (!real || std::set(texts.begin(), texts.end()).size() == texts.size()) break;
  }
  return texts;
}

}  // namespace pupflow::study
