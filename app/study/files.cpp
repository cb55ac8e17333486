#include "app/study/files.h"

#include <filesystem>

#include "app/io/failure.h"

namespace pupflow::study {

std::string runs_path(const std::string& folder) {
  return folder + "/runs.csv";
}
std::string summary_path(const std::string& folder) {
  return folder + "/summary.csv";
}
std::string manifest_path(const std::string& folder) {
  return folder + "/manifest.toml";
}
std::string journal_path(const std::string& folder) {
  return folder + "/journal.csv";
}
std::string table_path(const std::string& folder) {
  return folder + "/design.csv";
}

std::vector<std::string> picture_paths(const std::string& folder, const Design& design) {
  const std::string base = folder + "/" + design.name;
  return {base + ".png", base + ".svg"};
}

std::string script_path(const std::string& folder, const Design& design) {
  return folder + "/" + design.name + ".gp";
}

std::vector<std::string> result_paths(const std::string& folder, const Design& design) {
  std::vector<std::string> files = picture_paths(folder, design);
  files.push_back(runs_path(folder));
  files.push_back(summary_path(folder));
  return files;
}

void remove_file(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::remove(path, error) && error)
    throw io::Failure(io::ExitCode::bad_file, path + ": cannot remove: " + error.message());
}

}  // namespace pupflow::study
