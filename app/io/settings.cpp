#include "app/io/settings.h"

#include <algorithm>

#include "app/io/failure.h"
#include "app/io/nearest.h"
#include "app/io/params_of_file.h"
#include "app/io/scene_file.h"
#include "app/io/schedule_text.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

std::string unknown_parameter(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Parameter& parameter : parameters()) names.push_back(parameter.name);
  const std::string meant = did_you_mean(name, names);
  return "unknown parameter " + io::quoted(name) +
         (meant.empty() ? "; 'pupflow params' lists all" : meant);
}

/// Sets one parameter from text; what is wrong goes to `problems`, told to come from `option`.
void take(const std::string& option, std::string_view name, std::string_view value, Params& params,
          std::vector<std::string>& problems) {
  const Parameter* parameter = find_parameter(name);
  if (!parameter) {
    problems.push_back(option + ": " + unknown_parameter(name));
    return;
  }
  Problem problem;
  if (!parse_value(*parameter, value, params, problem)) {
    // A number as it was typed: in a double it may have other digits.
    const std::string start = std::string(parameter->name) + " = ";
    const std::size_t end = problem.message.find(": ");
    if (problem.message.starts_with(start) && read_number<double>(value)) {
      problem.message = start + std::string(value) + problem.message.substr(end);
    }
    problems.push_back(option + ": " + problem.message + did_you_mean(value, parameter->choices));
  }
}

void take_set(const std::string& set, Params& params, std::vector<std::string>& problems) {
  const std::size_t equals = set.find('=');
  if (equals == std::string::npos) {
    problems.push_back("--set " + io::quoted(set) + ": must be name=value, e.g. --set ta=0.2");
    return;
  }
  take("--set", set.substr(0, equals), set.substr(equals + 1), params, problems);
}

}  // namespace

bool Settings::empty() const {
  return scene.empty() && like.empty() && sets.empty() && at.empty() && !seed && !steps &&
         !precision && !flow_lag;
}

Setup set_up(const Settings& settings, const Params& base) {
  if (!settings.scene.empty() && !settings.like.empty()) {
    refuse("a scene and --like both give a whole parameter set; use one of them");
  }
  if (settings.row && settings.like.empty())
    refuse("--row names a row of --like FILE; give that file");
  Setup setup{base, {}, {}};
  std::vector<std::string> problems;
  if (!settings.scene.empty()) {
    const Scene scene = load_scene(settings.scene, problems);
    setup = {scene.params, printable(scene.title), printable(scene.description, "\n")};
  }
  if (!settings.like.empty()) setup.params = params_of_file(settings.like, settings.row);
  for (const std::string& set : settings.sets) take_set(set, setup.params, problems);
  const auto shortcut = [&](const char* option, const char* name,
                            const std::optional<std::string>& value) {
    if (value) take(option, name, *value, setup.params, problems);
  };
  shortcut("--seed", "seed", settings.seed);
  shortcut("--steps", "steps", settings.steps);
  shortcut("--precision", "precision", settings.precision);
  shortcut("--flow-lag", "flow_lag", settings.flow_lag);
  for (const std::string& change : settings.at) {
    add_change(change, "--at", setup.params.schedule, problems);
  }
  for (const Problem& problem : check(setup.params)) problems.push_back(problem.message);
  refuse_all(problems);
  return setup;
}

}  // namespace pupflow::io
