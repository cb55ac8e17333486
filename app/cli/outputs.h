// The files that one command writes.
#pragma once

#include <string>
#include <vector>

namespace pupflow::cli {

/// A file to be written, and the option that names it.
struct Output {
  std::string option, path;  // the path is empty where none was given
};

/// Refuses two outputs that are one file. Throws Failure(bad_input).
void refuse_same_file(const std::vector<Output>& outputs);

}  // namespace pupflow::cli
