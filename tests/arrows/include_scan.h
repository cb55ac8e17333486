// Reads the #include lines of the source tree and says which of them run against the arrows.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pupflow::arrows {

/// One #include line that may not be.
struct Violation {
  std::string file;  // relative to the root of the source tree
  int line;          // counted from 1
  std::string header;
  std::string reason;
};

/// The violations in `text`, the content of `file` (a path relative to the root, with '/').
std::vector<Violation> scan_text(const std::string& file, const std::string& text);

/// The violations in all .h and .cpp files below root/engine and root/app. `files` gets the number
/// of files read. Throws std::runtime_error when a file cannot be read.
std::vector<Violation> scan_tree(const std::filesystem::path& root, int& files);

}  // namespace pupflow::arrows
