#include "app/io/unfinished.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

#include "app/io/atomic_file.h"
#include "app/io/note.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNamed = 3;

/// Whether a process still has the file open as AtomicFile does.
bool is_written(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) return true;  // nothing to say about it
  const bool locked = ::flock(file, LOCK_EX | LOCK_NB) != 0;
  ::close(file);
  return locked;
}

/// NAME of a name that AtomicFile gives, NAME.PROCESS.unfinished; empty for any other.
std::string_view finished_name(std::string_view name) {
  if (!name.ends_with(kUnfinished)) return {};
  name.remove_suffix(kUnfinished.size());
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return {};
  const auto numbers = split(name.substr(dot + 1), '-');
  const bool all = std::all_of(numbers.begin(), numbers.end(), [](std::string_view number) {
    return read_number<std::uint32_t>(number).has_value();
  });
  return all ? name.substr(0, dot) : std::string_view();
}

}  // namespace

std::vector<Unfinished> unfinished_in(const std::string& folder) {
  std::vector<Unfinished> left;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code gone;
    const std::string file = at->path().filename().string();
    const std::string_view name = finished_name(file);
    if (!name.empty() && at->is_regular_file(gone) && !is_written(at->path()))
      left.push_back({at->path().string(), std::string(name)});
  }
  std::sort(left.begin(), left.end(),
            [](const Unfinished& a, const Unfinished& b) { return a.path < b.path; });
  return left;
}

void name_unfinished(std::span<const std::string> outputs) {
  std::set<std::string> folders;
  for (const std::string& output : outputs) {
    if (output.empty() || is_stream(output)) continue;
    folders.insert(fs::path(output).has_parent_path() ? fs::path(output).parent_path().string()
                                                      : std::string("."));
  }
  for (const std::string& folder : folders) {
    std::vector<Unfinished> left = unfinished_in(folder);
    if (left.empty()) continue;
    const std::size_t all = left.size();
    left.resize(std::min(all, kMostNamed));
    std::string names = joined(left, ", ", [](const Unfinished& file) { return file.path; });
    if (all > left.size()) names += " and " + std::to_string(all - left.size()) + " more";
    note("earlier runs left unfinished: " + names + " ('pupflow info FILE' tells what is in one)");
  }
}

}  // namespace pupflow::io
