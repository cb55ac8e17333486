#include "app/io/provenance.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string_view>

#include "app/io/failure.h"
#include "app/io/note.h"
#include "app/io/schedule_text.h"
#include "app/io/text.h"
#include "pupflow/version.h"

namespace pupflow::io {
namespace {

/// Entries that stand before parameters or among them: the version, a sweep's design (its manifest
/// is TOML, with "software" in small letters), and what HDF5 files say of themselves (their
/// attributes are read in the order of the alphabet).
constexpr std::string_view kBetween[] = {
    "Software",     "software", "name",   "vary",    "seeds", "runs", "shard",
    "ended early",  "kind",     "layout", "columns", "table", "lhs",  "seed_block",
    "record_every", "step",     "hash",   "edited",  "begun"};

/// The schedule, behind the parameters.
constexpr const char* kSchedule = "at";

/// The first of the entries behind the parameters, which tell of the output itself: of a picture,
/// of a report's file, of a sweep's figure.
constexpr std::string_view kBehind[] = {"picture", "command", "manifest"};

bool is_one_of(std::span<const std::string_view> names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Throws Failure(bad_input) when there is a parameter that this version does not know.
void refuse_unknown_parameter(const TextEntries& entries, const std::string& where) {
  for (const auto& [name, value] : entries) {
    if (is_one_of(kBehind, name)) return;
    if (name == kSchedule || is_one_of(kBetween, name) || find_parameter(name)) continue;
    refuse(where + ": this version has no parameter " + io::quoted(name));
  }
}

}  // namespace

std::string program_version() {
  return "pupflow " + std::string(version_text());
}

TextEntries provenance(const Params& params, const TextEntries& extra) {
  if (!extra.empty() && !is_one_of(kBehind, extra.front().first)) {
    throw std::logic_error("'" + extra.front().first + "' would be read as a parameter");
  }
  // "Software" is the keyword that the PNG standard has for it.
  TextEntries entries{{"Software", program_version()}};
  for (const Parameter& parameter : parameters()) {
    entries.emplace_back(parameter.name, format_value(parameter, params));
  }
  if (!params.schedule.empty()) entries.emplace_back(kSchedule, schedule_text(params.schedule));
  entries.insert(entries.end(), extra.begin(), extra.end());
  return entries;
}

TextEntries provenance(const Simulation& start) {
  TextEntries entries = provenance(start.recipe());
  if (start.steps_done() > 0) entries.emplace_back("begun", std::to_string(start.steps_done()));
  if (const auto step = start.edited()) entries.emplace_back("edited", std::to_string(*step));
  return entries;
}

void add_state(const Simulation& litter, TextEntries& entries) {
  entries.emplace_back("step", std::to_string(litter.steps_done()));
  entries.emplace_back("hash", hash_text(litter.hash()));
  if (const auto step = litter.edited()) entries.emplace_back("edited", std::to_string(*step));
}

Params params_from(const TextEntries& entries, const std::string& where) {
  const auto find = [&](std::string_view name) {
    return std::find_if(entries.begin(), entries.end(),
                        [&](const auto& entry) { return entry.first == name; });
  };
  const auto is_ours = [&](std::string_view key) {  // a sweep's manifest is TOML: small letters
    const auto entry = find(key);
    return entry != entries.end() && entry->second.starts_with("pupflow ");
  };
  if (!is_ours("Software") && !is_ours("software")) {
    refuse(where + ": does not say that pupflow wrote it, so it holds no parameters to take");
  }
  refuse_unknown_parameter(entries, where);
  Params params;
  std::vector<const Parameter*> missing;
  for (const Parameter& parameter : parameters()) {
    const auto entry = find(parameter.name);
    if (entry == entries.end()) {
      missing.push_back(&parameter);
      continue;
    }
    Problem problem;
    if (!parse_value(parameter, entry->second, params, problem)) {
      refuse(where + ": " + problem.message);
    }
  }
  take_as_before(missing, where, params);
  if (const auto at = find(kSchedule); at != entries.end()) {
    std::vector<std::string> problems;
    params.schedule = parse_schedule(at->second, where, problems);
    refuse_all(problems);
  }
  return params;
}

void take_as_before(const std::vector<const Parameter*>& missing, const std::string& where,
                    Params& params) {
  if (missing.empty()) return;
  for (const Parameter* parameter : missing) parameter->set(params, parameter->before);
  const std::string taken = joined(missing, ", ", [&](const Parameter* parameter) {
    return std::string(parameter->name) + " = " + format_value(*parameter, params);
  });
  note(where + " was written by an older version; taking " + taken);
}

}  // namespace pupflow::io
