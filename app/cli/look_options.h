// Options that pictures and the window share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/pictures/graphics.h"

namespace pupflow::cli {

/// The options as typed.
struct LookOptions {
  std::string colormap = "viridis";
  std::string scale = "0,1";
  std::string shader_dir;
  int supersample = 2;
  bool verbose = false;
};

/// Declares them.
void add_look(CLI::App& verb, LookOptions& options);

/// Checks them. Throws Failure(bad_input).
pictures::Look look_of(const LookOptions& options);

}  // namespace pupflow::cli
