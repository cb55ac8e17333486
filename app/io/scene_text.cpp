#include "app/io/scene_text.h"

#include "app/io/text.h"
#include "app/io/toml_text.h"

namespace pupflow::io {
namespace {

std::string line(std::string_view key, const std::string& value) {
  return std::string(key) + " = " + value + "\n";
}

std::string value_text(const Parameter& parameter, double value) {
  return parameter.kind == Parameter::Kind::choice ? toml_string(format_value(parameter, value))
                                                   : toml_number(value);
}

std::string change_table(const Change& change) {
  std::string text = "\n[[at]]\n" + line("step", std::to_string(change.step));
  if (change.until) text += line("until", std::to_string(*change.until));
  for (const auto& [place, value] : change.settings) {
    const Parameter& parameter = parameters()[place];
    text += line(parameter.name, value_text(parameter, value));
  }
  if (!change.pup) return text;
  const Action& action = change.action;
  text += line("pup", std::to_string(*change.pup));
  text += line("force", "[" + joined(action.force, ", ", toml_number) + "]");
  if (action.heat != 0) text += line("heat", toml_number(action.heat));
  if (action.turn) text += line("turn", toml_number(*action.turn));
  return text;
}

}  // namespace

std::string scene_text(const Scene& scene) {
  const auto words = [](const std::string& text) { return toml_string(printable(text, "\n\t")); };
  std::string text;
  if (!scene.title.empty()) text += line("title", words(scene.title));
  if (!scene.description.empty()) text += line("description", words(scene.description));
  for (const Parameter& parameter : parameters()) {
    const double value = parameter.get(scene.params);
    if (value == parameter.default_value() && parameter.name != "seed") continue;
    text += line(parameter.name, value_text(parameter, value));
  }
  for (const Change& change : scene.params.schedule.changes()) text += change_table(change);
  return text;
}

}  // namespace pupflow::io
