#include "app/io/provenance.h"

#include <algorithm>
#include <cstdio>

#include "app/io/failure.h"

namespace pupflow::io {

std::string version() {
  return PUPFLOW_VERSION;
}

TextEntries provenance(const Params& params, const TextEntries& extra) {
  // "Software" is the keyword that the PNG standard has for it.
  TextEntries entries{{"Software", "pupflow " PUPFLOW_VERSION}};
  for (const Parameter& parameter : parameters()) {
    entries.emplace_back(parameter.name, format_value(parameter, params));
  }
  entries.insert(entries.end(), extra.begin(), extra.end());
  return entries;
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
    throw Failure(
        ExitCode::bad_input,
        where + ": does not say that pupflow wrote it, so it holds no parameters to take");
  }
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
      throw Failure(ExitCode::bad_input, where + ": " + problem.message);
    }
  }
  take_as_before(missing, where, params);
  return params;
}

void take_as_before(const std::vector<const Parameter*>& missing, const std::string& where,
                    Params& params) {
  if (missing.empty()) return;
  std::string taken;
  for (const Parameter* parameter : missing) {
    parameter->set(params, parameter->before);
    taken += (taken.empty() ? "" : ", ") + std::string(parameter->name) + " = " +
             format_value(*parameter, params);
  }
  std::fprintf(stderr, "pupflow: note: %s was written by an older version; taking %s\n",
               where.c_str(), taken.c_str());
}

}  // namespace pupflow::io
