// Where the executable's modules are.
#pragma once

#include <string>
#include <vector>

#include "app/io/module.h"

namespace pupflow::cli {

/// Where the module `file` may be: in the executable's folder (build tree) or the library folder
/// that belongs to it (installed). Throws
/// std::filesystem::filesystem_error.
std::vector<std::string> module_candidates(const std::string& file);

/// Loads the module `file` and finds its symbol `entry`.
io::Module load_module(const std::string& file, const char* entry);

}  // namespace pupflow::cli
