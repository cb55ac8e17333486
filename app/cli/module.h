// Where the executable's modules are.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/io/module.h"

namespace pupflow::cli {

/// The executable's folder. Throws std::filesystem::filesystem_error where it is gone.
std::filesystem::path program_folder();

/// Where the module `file` may be: in the executable's folder (build tree) or the library folder
/// that belongs to it (installed). Throws as program_folder does.
std::vector<std::string> module_candidates(const std::string& file);

/// Loads the module `file` and finds its symbol `entry`.
io::Module load_module(const std::string& file, const char* entry);

}  // namespace pupflow::cli
