// Modules: parts of the program that need libraries of their own, loaded only when asked for.
#pragma once

#include <string>
#include <vector>

namespace pupflow::cli {

/// The files of the two modules.
constexpr const char* kGraphicsModule = "libpupflow_graphics.so";
constexpr const char* kMpiModule = "libpupflow_mpi.so";

/// Where the module `file` may be: in the executable's folder (build tree) or the library folder
/// that belongs to it (installed). Throws
/// std::filesystem::filesystem_error.
std::vector<std::string> module_candidates(const std::string& file);

/// What came of loading a module.
struct Module {
  void* entry = nullptr;  // the address of the symbol asked for
  std::string problem;    // why there is none: where it was looked for, or the loader's reason
  bool missing = false;   // it is in neither place
};

/// Loads the module `file`, for as long as the program lives, and finds its symbol `entry`.
Module load_module(const std::string& file, const char* entry);

}  // namespace pupflow::cli
