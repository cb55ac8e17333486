#include "app/io/provenance.h"

#include <algorithm>

#include "app/io/checkpoint.h"
#include "app/io/csv.h"
#include "app/io/failure.h"
#include "app/io/read_file.h"

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
  Params params;
  std::string missing;
  for (const Parameter& parameter : parameters()) {
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&](const auto& e) { return e.first == parameter.name; });
    if (entry == entries.end()) {
      missing += (missing.empty() ? "" : ", ") + std::string(parameter.name);
      continue;
    }
    Problem problem;
    if (!parse_value(parameter, entry->second, params, problem)) {
      throw Failure(ExitCode::bad_input, where + ": " + problem.message);
    }
  }
  if (missing.empty()) return params;
  throw Failure(ExitCode::bad_input, where +
                                         ": does not hold a full parameter set as this program "
                                         "writes it; missing: " +
                                         missing);
}

Params params_of_file(const std::string& path) {
  const std::string beginning = read_beginning(path, 8);
  if (beginning == "\x89PNG\r\n\x1a\n") return params_from(read_png_text(path), path);
  if (beginning == "\x89HDF\r\n\x1a\n") return params_from(read_hdf5_text(path), path);
  return params_from(read_csv_header(path), path);
}

}  // namespace pupflow::io
