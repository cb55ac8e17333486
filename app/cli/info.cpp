// pupflow info: what a file of this program holds.
#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/cli/verb.h"
#include "app/io/about.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/json.h"
#include "app/io/provenance.h"
#include "app/io/scene_file.h"
#include "app/io/table.h"
#include "app/io/text.h"
#include "app/study/files.h"
#include "app/study/folder.h"

namespace pupflow::cli {
namespace {

namespace fs = std::filesystem;

/// A sweep, by its folder.
io::About about_sweep(const std::string& folder) {
  std::error_code unreadable;
  if (!fs::exists(study::manifest_path(folder), unreadable) && !unreadable) {
    io::refuse(folder + ": is a folder without manifest.toml, so there is no sweep in it");
  }
  const study::Design design = study::design_of_folder(folder);
  io::About about;
  about.kind = "sweep";
  about.software = io::program_version();  // another version's manifest is refused
  about.params = design.base;
  about.facts.emplace_back("name", io::printable(design.name));
  for (const study::Axis& axis : design.axes) {
    about.facts.emplace_back("varied", std::string(axis.parameter->name) + " over " +
                                           std::to_string(axis.values.size()) + " values, " +
                                           format_value(*axis.parameter, axis.values.front()) +
                                           " to " +
                                           format_value(*axis.parameter, axis.values.back()));
  }
  about.facts.emplace_back("seeds", std::to_string(design.seeds));
  about.facts.emplace_back("runs", std::to_string(design.own_runs().size()));
  const bool finished = fs::exists(study::runs_path(folder), unreadable);
  about.facts.emplace_back("finished", finished ? "yes" : "no; the same command goes on");
  return about;
}

io::About about_scene(const std::string& path) {
  std::vector<std::string> problems;
  const io::Scene scene = io::load_scene(path, problems);
  io::refuse_all(problems);
  io::About about;
  about.kind = "scene";
  about.params = scene.params;
  about.facts.emplace_back("title", io::printable(scene.title));
  std::string description = scene.description;
  std::replace(description.begin(), description.end(), '\n', ' ');
  about.facts.emplace_back("description", io::printable(description));
  return about;
}

io::About about(const std::string& path) {
  const fs::path place(path);
  std::error_code unreadable;
  if (fs::is_directory(place, unreadable)) return about_sweep(path);
  const fs::path folder = place.has_parent_path() ? place.parent_path() : fs::path(".");
  if (place.filename() == "manifest.toml") return about_sweep(folder.string());
  if (place.extension() == ".toml") return about_scene(path);
  return io::about_file(path);
}

/// Parameters that are not at their defaults.
std::string changed_text(const Params& params) {
  std::vector<std::string> changed;
  for (const Parameter& row : parameters()) {
    if (row.get(params) == row.default_value()) continue;
    changed.push_back(std::string(row.name) + " = " + format_value(row, params));
  }
  return changed.empty() ? "all at their defaults"
                         : io::joined(changed, ", ") + "; all others at their defaults";
}

std::string shape_text(const io::SetInfo& set) {
  if (set.shape.empty()) return "1";
  return io::joined(set.shape, " x ", [](std::uint64_t size) { return std::to_string(size); });
}

std::string text(const std::string& path, const io::About& about) {
  std::vector<io::Row> rows;
  if (!about.software.empty()) rows.push_back({"written by", about.software});
  rows.push_back({"parameters", changed_text(about.params)});
  for (const auto& [name, value] : about.facts) rows.push_back({name, value});
  const std::string all = io::printable(path) + ": " + about.kind + "\n" + io::aligned(rows);
  if (about.sets.empty()) return all;
  std::vector<io::Row> sets{{"name", "shape", "type", "unit", "meaning"}};
  for (const io::SetInfo& set : about.sets) {
    sets.push_back({set.name, shape_text(set), set.type, set.units, set.description});
  }
  return all + "\n" + io::aligned(sets);
}

std::string json_object(const io::JsonObject& members) {
  return "{" +
         io::joined(members, ", ",
                    [](const auto& member) {
                      return io::json_string(member.first) + ": " + member.second;
                    }) +
         "}";
}

std::string json(const std::string& path, const io::About& about) {
  io::JsonObject params, facts;
  for (const Parameter& row : parameters()) {
    const double value = row.get(about.params);
    params.emplace_back(row.name, row.kind == Parameter::Kind::choice
                                      ? io::json_string(format_value(row, value))
                                      : io::json_number(value));
  }
  for (const auto& [name, value] : about.facts) {
    facts.emplace_back(name, io::json_string(value));
  }
  std::vector<std::string> sets;
  for (const io::SetInfo& set : about.sets) {
    const std::string shape =
        io::joined(set.shape, ", ", [](std::uint64_t size) { return std::to_string(size); });
    sets.push_back(json_object({{"name", io::json_string(set.name)},
                                {"shape", "[" + shape + "]"},
                                {"type", io::json_string(set.type)},
                                {"unit", io::json_string(set.units)},
                                {"description", io::json_string(set.description)}}));
  }
  return json_object({{"file", io::json_string(io::printable(path))},
                      {"kind", io::json_string(about.kind)},
                      {"software", io::json_string(about.software)},
                      {"parameters", json_object(params)},
                      {"facts", json_object(facts)},
                      {"sets", "[" + io::joined(sets, ", ") + "]"}}) +
         "\n";
}

}  // namespace

Verb add_info(CLI::App& program) {
  CLI::App* app = program.add_subcommand("info", "Tell what a file of this program holds");
  const auto path = std::make_shared<std::string>();
  const auto as_json = std::make_shared<bool>(false);
  app->add_option("FILE", *path,
                  "A picture, CSV, recording, checkpoint, scene or the folder of a sweep")
      ->option_text(" ")
      ->required()
      ->check(not_empty);
  app->add_flag("--json", *as_json, "As JSON, with all parameters");
  return {app,
          [path, as_json] {
            const io::About found = about(*path);
            io::print(*as_json ? json(*path, found) : text(*path, found));
          },
          {{"info run.h5", "What a recording holds"},
           {"info figure1.png", "The recipe that a picture carries"}}};
}

}  // namespace pupflow::cli
