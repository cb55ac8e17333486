#include "app/window/file_list.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <tuple>

#include "app/io/text.h"

namespace pupflow::window {
namespace {

namespace fs = std::filesystem;

// What carries a recipe, scenes first.
constexpr std::array<std::string_view, 5> kEndings{".toml", ".h5", ".hdf5", ".png", ".csv"};

/// The place of the ending of `name` in kEndings.
std::size_t kind_of(const std::string& name) {
  const auto fits = [&](std::string_view ending) { return name.ends_with(ending); };
  return static_cast<std::size_t>(std::ranges::find_if(kEndings, fits) - kEndings.begin());
}

}  // namespace

FileList list_files(const std::string& folder, bool scenes_only) {
  FileList list;
  list.folder = path_from("/", folder);
  std::error_code error;
  const std::size_t kinds = scenes_only ? 1 : kEndings.size();
  for (fs::directory_iterator file(list.folder, error), end; !error && file != end;
       file.increment(error)) {
    const std::string name = file->path().filename().string();
    if (name.starts_with('.') || io::printable(name) != name) continue;
    std::error_code unknown;
    const bool is_folder = file->is_directory(unknown);
    if (!is_folder && kind_of(name) >= kinds) continue;
    if (list.entries.size() == FileList::kMost) {
      list.problem = "only " + std::to_string(FileList::kMost) + " entries are listed; type a name";
      break;
    }
    list.entries.push_back({name, is_folder});
  }
  if (error) list.problem = "cannot list " + list.folder + ": " + error.message();
  std::ranges::sort(list.entries, {}, [](const FileList::Entry& entry) {
    return std::tuple(!entry.folder, entry.folder ? 0 : kind_of(entry.name), entry.name);
  });
  return list;
}

std::string path_from(const std::string& folder, const std::string& typed) {
  fs::path path = typed;
  const char* const home = std::getenv("HOME");
  if (home != nullptr && (typed == "~" || typed.starts_with("~/"))) {
    path = fs::path(home) / (typed.size() > 2 ? typed.substr(2) : "");
  }
  path = (fs::path(folder) / path).lexically_normal();  // a whole path stands for itself
  if (!path.has_filename() && path.has_relative_path()) path = path.parent_path();
  return path.string();
}

}  // namespace pupflow::window
