#include "app/io/schedule_text.h"

#include <algorithm>
#include <optional>

#include "app/io/nearest.h"
#include "app/io/text.h"
#include "pupflow/parameters.h"

namespace pupflow::io {
namespace {

constexpr const char* kExample = "e.g. step=800,ta=0.2";

/// What the entries of an action are called, beside those that every change may have.
constexpr std::string_view kActions[] = {"force", "heat", "turn"};

bool is_action(std::string_view name) {
  return std::find(std::begin(kActions), std::end(kActions), name) != std::end(kActions);
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

std::string unknown(std::string_view name) {
  std::vector<std::string_view> names{"step", "until", "pup"};
  names.insert(names.end(), std::begin(kActions), std::end(kActions));
  for (const Parameter& parameter : parameters()) {
    if (parameter.effect == Parameter::Effect::next_step) names.push_back(parameter.name);
  }
  const std::string meant = did_you_mean(name, names);
  return "a change has no " + io::quoted(name) +
         (meant.empty() ? "; it has step, until, and parameters or pup, force, heat, turn" : meant);
}

/// Takes a number; says what would be right when it is none.
template <class Number>
std::string take_number(std::string_view name, std::string_view text, Number& number) {
  const auto value = read_number<Number>(text);
  if (value) {
    number = *value;
    return {};
  }
  const char* kind =
      std::is_integral_v<Number> ? " must be a whole number, not " : " must be a number, not ";
  return std::string(name) + kind + io::quoted(text);
}

std::string take_force(std::string_view text, std::array<double, 3>& force) {
  const std::string wrong = "force must be three numbers, e.g. [2,0,0], not " + io::quoted(text);
  if (!text.starts_with('[') || !text.ends_with(']')) return wrong;
  const std::vector<std::string_view> parts = split(text.substr(1, text.size() - 2), ',');
  if (parts.size() != 3) return wrong;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto number = read_number<double>(trimmed(parts[axis]));
    if (!number) return wrong;
    force[axis] = *number;
  }
  return {};
}

std::string take_action(std::string_view name, std::string_view text, Action& action) {
  if (name == "force") return take_force(text, action.force);
  if (name == "heat") return take_number(name, text, action.heat);
  return take_number(name, text, action.turn.emplace());
}

std::string take_parameter(std::string_view name, std::string_view text, Change& change) {
  const Parameter* parameter = find_parameter(name);
  if (!parameter) return unknown(name);
  Params params;
  Problem problem;
  if (!parse_value(*parameter, text, params, problem)) {
    return problem.message + did_you_mean(text, parameter->choices);
  }
  const auto place = static_cast<std::size_t>(parameter - parameters().data());
  change.settings.push_back({place, parameter->get(params)});
  return {};
}

/// The entries of "step=800,force=[2,0,0]": commas in brackets do not separate.
std::optional<TextEntries> entries_of(std::string_view text) {
  TextEntries entries;
  while (true) {
    int depth = 0;
    const auto separates = [&](char letter) {
      depth += letter == '[' ? 1 : letter == ']' ? -1 : 0;
      return letter == ',' && depth == 0;
    };
    const auto end = std::find_if(text.begin(), text.end(), separates);
    const auto size = static_cast<std::size_t>(end - text.begin());
    const std::string_view entry = text.substr(0, size);
    const std::size_t equals = entry.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    entries.emplace_back(trimmed(entry.substr(0, equals)), trimmed(entry.substr(equals + 1)));
    if (end == text.end()) return entries;
    text.remove_prefix(size + 1);
  }
}

}  // namespace

Change read_change(const TextEntries& entries, std::vector<ChangeProblem>& problems) {
  Change change;
  const auto has = [&](std::string_view name) {
    return std::any_of(entries.begin(), entries.end(),
                       [&](const auto& entry) { return entry.first == name; });
  };
  const bool acts = has("pup");
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto& [name, text] = entries[i];
    std::string wrong;
    if (std::any_of(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(i),
                    [&, &name = name](const auto& entry) { return entry.first == name; })) {
      wrong = name + " is given twice";
    } else if (name == "step") {
      wrong = take_number(name, text, change.step);
    } else if (name == "until") {
      wrong = take_number(name, text, change.until.emplace());
    } else if (name == "pup") {
      wrong = take_number(name, text, change.pup.emplace());
    } else if (acts && is_action(name)) {
      wrong = take_action(name, text, change.action);
    } else if (!acts && (name == "force" || name == "turn")) {
      wrong = name + " acts on one pup; name it, e.g. pup=3";
    } else {
      wrong = take_parameter(name, text, change);
    }
    if (!wrong.empty()) problems.push_back({i, wrong});
  }
  if (!has("step")) problems.push_back({0, "a change needs its step, " + std::string(kExample)});
  return change;
}

void add_change(std::string_view text, const std::string& where, Schedule& schedule,
                std::vector<std::string>& problems) {
  const std::optional<TextEntries> entries = entries_of(text);
  if (!entries) {
    problems.push_back(where + ": " + io::quoted(text) + " is no change, " + kExample);
    return;
  }
  std::vector<ChangeProblem> found;
  const Change change = read_change(*entries, found);
  for (const ChangeProblem& problem : found) problems.push_back(where + ": " + problem.message);
  if (found.empty()) schedule.add(change);
}

std::string change_text(const Change& change) {
  std::string text = "step=" + std::to_string(change.step);
  const auto add = [&](std::string_view name, const std::string& value) {
    text.append(",").append(name).append("=").append(value);
  };
  if (change.until) add("until", std::to_string(*change.until));
  for (const auto& [place, value] : change.settings) {
    const Parameter& parameter = parameters()[place];
    add(parameter.name, format_value(parameter, value));
  }
  if (!change.pup) return text;
  add("pup", std::to_string(*change.pup));
  const Action& action = change.action;
  if (action.force != std::array<double, 3>{}) {
    add("force", "[" + joined(action.force, ",", number_text) + "]");
  }
  if (action.heat != 0) add("heat", number_text(action.heat));
  if (action.turn) add("turn", number_text(*action.turn));
  return text;
}

std::string schedule_text(const Schedule& schedule) {
  return joined(schedule.changes(), "; ", change_text);
}

Schedule parse_schedule(std::string_view text, const std::string& where,
                        std::vector<std::string>& problems) {
  Schedule schedule;
  for (const std::string_view change : split(text, ';')) {
    add_change(trimmed(change), where, schedule, problems);
  }
  return schedule;
}

}  // namespace pupflow::io
