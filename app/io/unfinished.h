// Files that runs left when they were killed or the disk was full.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace pupflow::io {

/// A file that AtomicFile left unfinished, and the name of the file that it would have become.
struct Unfinished {
  std::string path, name;
};

/// Those in a folder that no process writes any more.
std::vector<Unfinished> unfinished_in(const std::string& folder);

/// Says in one line on standard error which unfinished files in the folders of `outputs` (files, or
/// empty) no process writes any more. They are left alone.
void name_unfinished(std::span<const std::string> outputs);

}  // namespace pupflow::io
