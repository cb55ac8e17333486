// What a file dialog shows of a folder.
#pragma once

#include <string>
#include <vector>

namespace pupflow::window {

struct FileList {
  struct Entry {
    std::string name;
    bool folder = false;
  };

  static constexpr std::size_t kMost = 2000;  // entries that are listed

  std::string folder;          // a whole path
  std::vector<Entry> entries;  // folders, scenes, then other files that can be opened; by name
  std::string problem;         // why it is not, or not all, listed; empty where it is
};

/// The folder and what in it can be opened. Hidden files, and names that are no printable text, are
/// left out. With `scenes_only` so are all files but scenes.
FileList list_files(const std::string& folder, bool scenes_only);

/// The whole path that was typed or picked, seen from `folder`; "~" is the home folder.
std::string path_from(const std::string& folder, const std::string& typed);

}  // namespace pupflow::window
