#include "app/io/command_text.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "app/io/schedule_text.h"

namespace pupflow::io {
namespace {

/// The changes of `all` without those of `base`, one by one.
std::vector<Change> added(const Schedule& all, const Schedule& base) {
  const auto changes = all.changes();
  std::vector<Change> rest(changes.begin(), changes.end());
  for (const Change& change : base.changes()) {
    const auto same = std::find(rest.begin(), rest.end(), change);
    if (same != rest.end()) rest.erase(same);
  }
  return rest;
}

bool makes(const Schedule& base, const std::vector<Change>& changes, const Schedule& wanted) {
  Schedule made = base;
  for (const Change& change : changes) made.add(change);
  return made == wanted;
}

}  // namespace

std::string shell_word(const std::string& word) {
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("_-./=,:+%@").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  return quoted + "'";
}

std::string command_text(const std::string& scene, const Params& base, const Params& recipe,
                         std::int64_t steps) {
  const std::vector<Change> changes = added(recipe.schedule, base.schedule);
  if (!makes(base.schedule, changes, recipe.schedule)) {
    return command_text("", Params{}, recipe, steps);
  }
  std::string text = "pupflow run";
  if (!scene.empty()) text += ' ' + shell_word(scene);
  for (const Parameter& parameter : parameters()) {
    const double value = parameter.get(recipe);
    if (value == parameter.get(base) || parameter.name == "seed" || parameter.name == "steps") {
      continue;
    }
    text += " --set " + std::string(parameter.name) + "=" + format_value(parameter, value);
  }
  for (const Change& change : changes) text += " --at " + shell_word(change_text(change));
  return text + " --seed " + std::to_string(recipe.seed) + " --steps " + std::to_string(steps);
}

}  // namespace pupflow::io
