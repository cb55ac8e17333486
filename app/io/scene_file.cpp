#include "app/io/scene_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>

#include "app/io/failure.h"
#include "app/io/nearest.h"
#include "app/io/read_file.h"
#include "app/io/schedule_text.h"
#include "app/io/text.h"
#include "app/io/toml_depth.h"
#include "app/io/toml_problem.h"

namespace pupflow::io {
namespace {

constexpr std::size_t kLargestScene = 1 << 20;

std::string located(const std::string& name, const toml::source_region& where) {
  return name + ":" + std::to_string(where.begin.line) + ":" + std::to_string(where.begin.column) +
         ": ";
}

/// The entries of a table from top to bottom, as people read files; the table itself is sorted by
/// key.
std::vector<std::pair<const toml::key*, const toml::node*>> in_order(const toml::table& table) {
  std::vector<std::pair<const toml::key*, const toml::node*>> entries;
  for (auto&& [key, value] : table) entries.emplace_back(&key, &value);
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return a.first->source().begin < b.first->source().begin;
  });
  return entries;
}

std::string_view type_words(toml::node_type type) {
  switch (type) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number with a fraction";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

std::string_view wanted_words(Parameter::Kind kind) {
  switch (kind) {
    case Parameter::Kind::real:
      return "a number";
    case Parameter::Kind::integer:
      return "a whole number";
    case Parameter::Kind::choice:
      return "a string";
  }
  return {};
}

/// The key of the tables that say what changes during the run.
constexpr const char* kAt = "at";

std::string wrong_type(std::string_view key, std::string_view wanted, const toml::node& value) {
  return std::string(key) + " must be " + std::string(wanted) + ", not " +
         std::string(type_words(value.type()));
}

/// Takes one key that names a parameter; returns what is wrong with its value, or nothing.
std::string take_parameter(const Parameter& parameter, const toml::node& value, Params& params) {
  Problem problem;
  if (parameter.kind == Parameter::Kind::choice) {
    const auto text = value.value_exact<std::string>();
    if (!text) return wrong_type(parameter.name, wanted_words(parameter.kind), value);
    if (parse_value(parameter, *text, params, problem)) return {};
    return problem.message + did_you_mean(*text, parameter.choices);
  }
  const bool right_type =
      value.is_integer() || (parameter.kind == Parameter::Kind::real && value.is_floating_point());
  if (!right_type) return wrong_type(parameter.name, wanted_words(parameter.kind), value);
  // Through as_integer: toml++ refuses to convert a whole number that a double cannot hold.
  const double number = value.is_integer() ? static_cast<double>(value.as_integer()->get())
                                           : value.as_floating_point()->get();
  if (check_value(parameter, number, problem)) parameter.set(params, number);
  return problem.message;
}

std::string unknown_key(std::string_view key, const toml::node& value) {
  if (value.is_table()) {
    return io::quoted(key) + " is a table, but a scene is a flat list of name = value";
  }
  std::vector<std::string_view> names{"title", "description", kAt};
  for (const Parameter& parameter : parameters()) names.push_back(parameter.name);
  const std::string meant = did_you_mean(key, names);
  return "unknown key " + io::quoted(key) +
         (meant.empty() ? "; 'pupflow params' lists all" : meant);
}

/// Takes one key of the scene; returns what is wrong with it, or nothing.
std::string take_key(std::string_view key, const toml::node& value, Scene& scene) {
  if (key == "title" || key == "description") {
    const auto text = value.value_exact<std::string>();
    if (!text) return wrong_type(key, "a string", value);
    (key == "title" ? scene.title : scene.description) = *text;
    return {};
  }
  const Parameter* parameter = find_parameter(key);
  return parameter ? take_parameter(*parameter, value, scene.params) : unknown_key(key, value);
}

/// An entry of a change as it would be typed; nothing when it is neither word, number nor numbers.
std::optional<std::string> typed(const toml::node& value) {
  if (const auto word = value.value_exact<std::string>()) return *word;
  if (value.is_integer()) return std::to_string(value.as_integer()->get());
  if (value.is_floating_point()) return number_text(value.as_floating_point()->get());
  const toml::array* items = value.as_array();
  if (items == nullptr) return std::nullopt;
  std::string text;
  for (const toml::node& item : *items) {
    const std::optional<std::string> number = item.is_array() ? std::nullopt : typed(item);
    if (!number) return std::nullopt;
    text += (text.empty() ? "" : ",") + *number;
  }
  return "[" + text + "]";
}

/// Takes one [[at]] table.
void take_change(const toml::table& table, const std::string& name, Scene& scene,
                 std::vector<std::string>& problems) {
  TextEntries entries;
  std::vector<toml::source_region> places;
  for (const auto& [key, value] : in_order(table)) {
    const std::optional<std::string> text = typed(*value);
    if (text) {
      entries.emplace_back(key->str(), *text);
      places.push_back(value->source());
    } else {
      problems.push_back(located(name, value->source()) +
                         wrong_type(key->str(), "a number, a word or three numbers", *value));
    }
  }
  std::vector<ChangeProblem> found;
  const Change change = read_change(entries, found);
  if (found.empty() && entries.size() == table.size()) scene.params.schedule.add(change);
  for (const ChangeProblem& problem : found) {
    const toml::source_region& place =
        problem.entry < places.size() ? places[problem.entry] : table.source();
    problems.push_back(located(name, place) + problem.message);
  }
}

/// Takes all changes of a scene.
void take_changes(const toml::node& value, const std::string& name, Scene& scene,
                  std::vector<std::string>& problems) {
  const toml::array* tables = value.as_array();
  if (tables == nullptr || !tables->is_homogeneous(toml::node_type::table)) {
    problems.push_back(located(name, value.source()) +
                       "changes are written as [[at]] tables, each with its step");
    return;
  }
  for (const toml::node& table : *tables) take_change(*table.as_table(), name, scene, problems);
}

/// Whether the user surely means a file rather than a shipped scene.
bool looks_like_path(const std::string& scene) {
  return scene == "-" || scene.find('/') != std::string::npos || scene.ends_with(".toml");
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& name,
                  std::vector<std::string>& problems) {
  Scene scene;
  if (const std::string wrong = too_deep(text); !wrong.empty()) {
    problems.push_back(name + ":" + wrong);
    return scene;
  }
  try {
    const toml::table table = toml::parse(text, name);
    for (const auto& [key, value] : in_order(table)) {
      if (key->str() == kAt) {
        take_changes(*value, name, scene, problems);
        continue;
      }
      const std::string wrong = take_key(key->str(), *value, scene);
      const toml::source_region& where =
          find_parameter(key->str()) ? value->source() : key->source();
      if (!wrong.empty()) problems.push_back(located(name, where) + wrong);
    }
  } catch (const toml::parse_error& error) {
    problems.push_back(located(name, error.source()) + toml_problem(error.description()));
  }
  return scene;
}

Scene load_scene(const std::string& scene, std::vector<std::string>& problems) {
  const auto shipped = shipped_scenes();
  const auto found = std::find_if(shipped.begin(), shipped.end(),
                                  [&](const ShippedScene& s) { return s.name == scene; });
  if (found != shipped.end()) return parse_scene(found->text, scene + ".toml", problems);
  if (looks_like_path(scene)) {
    const std::string name = scene == "-" ? "standard input" : scene;
    return parse_scene(read_file(scene, kLargestScene), name, problems);
  }
  std::error_code ignored;
  if (std::filesystem::exists(scene, ignored)) {
    refuse(io::quoted(scene) +
           ": a scene file is given as a path with '/' or ending in .toml, an "
           "output of this program with --like");
  }
  std::vector<std::string_view> names;
  for (const ShippedScene& s : shipped) names.push_back(s.name);
  const std::string meant = did_you_mean(scene, names);
  refuse("no scene " + io::quoted(scene) +
         (meant.empty() ? "; shipped: " + joined(names, ", ") +
                              "; a scene file is given as a path with '/' or ending in .toml"
                        : meant));
}

}  // namespace pupflow::io
