#include "app/window/parameter_text.h"

namespace pupflow::window {

std::string label_of(const Parameter& parameter) {
  return std::string(parameter.symbol.empty() ? parameter.name : parameter.symbol);
}

std::string difference_text(const Params& from, const Params& to, int most) {
  std::string text;
  int count = 0;
  for (const Parameter& parameter : parameters()) {
    if (parameter.get(from) == parameter.get(to) || ++count > most) continue;
    if (!text.empty()) text += ", ";
    text += label_of(parameter) + ' ' + format_value(parameter, from) + " \u2192 " +
            format_value(parameter, to);
  }
  if (count > most) text += " and " + std::to_string(count - most) + " more";
  return text;
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
