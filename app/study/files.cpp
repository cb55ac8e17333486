#include "app/study/files.h"

#include <signal.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

#include "app/io/failure.h"
#include "app/io/text.h"
#include "app/io/unfinished.h"

namespace pupflow::study {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& message) {
  throw io::Failure(io::ExitCode::bad_file, message);
}

/// Whether it is ".pupflow-PID-N.plot" (io::draw) of a process that has ended.
bool is_old_drawing(std::string_view name) {
  constexpr std::string_view kStart = ".pupflow-", kEnd = ".plot";
  if (!name.starts_with(kStart) || !name.ends_with(kEnd)) return false;
  name.remove_prefix(kStart.size());
  name.remove_suffix(kEnd.size());
  const auto parts = io::split(name, '-');
  const auto process = io::read_number<pid_t>(parts[0]);
  return parts.size() == 2 && process && *process > 0 && io::read_number<unsigned>(parts[1]) &&
         ::kill(*process, 0) != 0 && errno == ESRCH;
}

/// The files that every sweep may have, but for its series.
std::vector<std::string> own_paths(const std::string& folder, const Design& design) {
  std::vector<std::string> paths = result_paths(folder, design);
  for (const std::string& path : {manifest_path(folder), journal_path(folder), table_path(folder),
                                  script_path(folder, design)})
    paths.push_back(path);
  return paths;
}

}  // namespace

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

std::string series_folder(const std::string& folder) {
  return folder + "/series";
}
std::string lock_path(const std::string& folder) {
  return folder + "/sweep.lock";
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

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail(folder + ": cannot make this folder: " + error.message());
}

void refuse_no_file(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(path, ignored);
  if (!fs::exists(status) || fs::is_regular_file(status)) return;
  fail(path +
       (fs::is_symlink(status) ? ": is a symbolic link, through which no sweep writes"
                               : ": is no regular file") +
       "; remove it, or name another folder with --out");
}

void refuse_links(const std::string& folder, const Design& design) {
  for (const std::string& path : own_paths(folder, design)) refuse_no_file(path);
  std::error_code ignored;
  const std::string series = series_folder(folder);
  if (design.record_every > 0 && fs::is_symlink(series, ignored))
    fail(series +
         ": is a symbolic link, through which no sweep writes; remove it, or name another "
         "folder with --out");
}

void remove_file(const std::string& path) {
  std::error_code error;
  if (!fs::remove(path, error) && error) fail(path + ": cannot remove: " + error.message());
}

void remove_leftovers(const std::string& folder, const Design& design) {
  std::error_code error;
  const std::vector<std::string> own = own_paths(folder, design);
  std::vector<fs::path> found;
  for (const io::Unfinished& file : io::unfinished_in(folder))
    if (std::find(own.begin(), own.end(), folder + "/" + file.name) != own.end())
      found.emplace_back(file.path);
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (is_old_drawing(entry.path().filename().string())) found.push_back(entry.path());
  const std::string series = series_folder(folder);
  if (design.record_every > 0 && !fs::is_symlink(series, error))
    for (const io::Unfinished& file : io::unfinished_in(series)) found.emplace_back(file.path);
  for (const fs::path& path : found) fs::remove_all(path, error);
}

}  // namespace pupflow::study
