#include "python/words.h"

#include <cmath>

#include "app/io/text.h"

namespace pupflow::python {
namespace {

std::string in_brackets(std::string_view unit) {
  return unit.empty() ? "" : " [" + std::string(unit) + "]";
}

std::string_view effect_words(Parameter::Effect effect) {
  switch (effect) {
    case Parameter::Effect::next_step:
      return "A change acts from the next step on.";
    case Parameter::Effect::restart:
      return "Defines the litter: only a new Litter takes another value.";
    case Parameter::Effect::run:
      return "Belongs to a run, not to the litter.";
  }
  return {};
}

std::string end_text(double value) {
  return std::isnan(value) ? "data" : io::number_text(value);
}

}  // namespace

std::string words(const Parameter& parameter) {
  std::string text(parameter.title);
  if (!parameter.symbol.empty()) text += " " + std::string(parameter.symbol);
  text += in_brackets(parameter.unit) + ": " + range_text(parameter) + "; " +
          format_value(parameter, parameter.default_value()) + " by default.\n\n";
  text += std::string(parameter.doc) + "\n" + std::string(effect_words(parameter.effect)) + "\n";
  return text + "Source: " + std::string(parameter.source);
}

std::string words(const Field& field, const std::string& shape) {
  std::string text = shape + (shape.empty() ? "" : " ") + std::string(field.label);
  if (!field.symbol.empty()) text += " " + std::string(field.symbol);
  text += in_brackets(field.unit) + ", " + std::string(kind_name(field.kind)) + ", drawn from " +
          end_text(field.low) + " to " + end_text(field.high) + ".\n\n" + std::string(field.doc);
  if (!field.equation.empty()) text += "\n" + std::string(field.equation);
  return text;
}

}  // namespace pupflow::python
