// Modules: parts of the program that need libraries of their own, loaded only when asked for.
#pragma once

#include <string>
#include <vector>

namespace pupflow::io {

/// The files of the two modules.
constexpr const char* kGraphicsModule = "libpupflow_graphics.so";
constexpr const char* kMpiModule = "libpupflow_mpi.so";

/// What came of loading a module.
struct Module {
  void* entry = nullptr;  // the address of the symbol asked for
  std::string problem;    // why there is none: where it was looked for, or the loader's reason
  bool missing = false;   // it is in none of the places
};

/// Loads the first of these files that exists, for as long as the program lives, and finds its
/// symbol `entry`.
Module load_module(const std::vector<std::string>& candidates, const char* entry);

}  // namespace pupflow::io
