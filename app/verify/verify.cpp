#include "app/verify/verify.h"

#include <algorithm>
#include <filesystem>

#include "app/io/csv.h"
#include "app/io/failure.h"
#include "app/io/file_kind.h"
#include "app/io/params_of_file.h"
#include "app/verify/kinds.h"

namespace pupflow::verify {
namespace {

bool has_column(const std::vector<std::string>& columns, const char* name) {
  return std::find(columns.begin(), columns.end(), name) != columns.end();
}

Verdict verify_csv(const std::string& path, const Options& options) {
  const io::TextEntries entries = io::entries_of_file(path);
  if (const std::string* command = find_entry(entries, "command"); command && *command == "live") {
    io::refuse(path +
               ": holds the plots of the live window, which join steps, so it cannot be repeated; "
               "save the scene and `pupflow run` it");
  }
  const std::vector<std::string> columns = io::CsvReader(path).columns();
  if (has_column(columns, "status")) return verify_runs(path, options);
  if (columns == io::metrics_columns()) return verify_metrics(path, options);
  if (columns == io::pups_columns()) return verify_pups(path, options);
  io::refuse(path +
             ": cannot be repeated; its columns are not those that this version writes for a run, "
             "its pups or a sweep's runs");
}

}  // namespace

Verdict verify(const std::string& path, const Options& options) {
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(path, ignored);
  const std::string file = folder ? path + "/runs.csv" : path;
  const io::FileKind kind_of_file = io::file_kind(file);
  const bool picture = kind_of_file == io::FileKind::picture;
  const bool hdf5 = kind_of_file == io::FileKind::hdf5;
  if (options.row && (picture || hdf5)) io::refuse(path + ": --row takes a sweep's runs.csv");
  if (picture) return verify_picture(file, options);
  if (hdf5) {
    const io::TextEntries entries = io::entries_of_file(file);
    const std::string* kind = find_entry(entries, "kind");
    const bool recording = kind && *kind == "recording";
    return recording ? verify_recording(file, options) : verify_checkpoint(file, options);
  }
  return verify_csv(file, options);
}

}  // namespace pupflow::verify
