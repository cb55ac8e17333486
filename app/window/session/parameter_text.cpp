#include "app/window/session/parameter_text.h"

#include <algorithm>

namespace pupflow::window {

std::string label_of(const Parameter& parameter) {
  return std::string(parameter.symbol.empty() ? parameter.name : parameter.symbol);
}

std::string titled(std::string_view symbol, std::string_view title) {
  return std::string(symbol) + (symbol.empty() ? "" : "  ") + std::string(title);
}

std::string text_of(const std::vector<Edited>& values, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(values.size(), most); ++i) {
    const Parameter& parameter = parameters()[values[i].parameter];
    if (i > 0) text += ", ";
    text += label_of(parameter) + ' ' + format_value(parameter, values[i].from) + " \u2192 " +
            format_value(parameter, values[i].to);
  }
  if (values.size() > most) text += " and " + std::to_string(values.size() - most) + " more";
  return text;
}

std::string difference_text(const Params& from, const Params& to, std::size_t most) {
  std::vector<Edited> values;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const double before = parameters()[i].get(from), after = parameters()[i].get(to);
    if (before != after) values.push_back({i, before, after});
  }
  return text_of(values, most);
}

std::string differing_values(const Params& own, const Params& other) {
  std::string text;
  for (const Parameter& parameter : parameters()) {
    if (parameter.get(own) == parameter.get(other)) continue;
    if (!text.empty()) text += ", ";
    text += label_of(parameter) + " = " + format_value(parameter, own);
  }
  return text;
}

}  // namespace pupflow::window
