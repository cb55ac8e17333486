// Options that pictures and the window share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/pictures/look.h"

namespace pupflow::cli {

/// The options as typed.
struct LookOptions {
  std::string color_by = "tb";
  std::string colormap, scale;  // empty: the field's own
  std::string shader_dir;
  int supersample = pictures::Look{}.supersample;
  bool verbose = false;
};

/// Declares them.
void add_look(CLI::App& verb, LookOptions& options);

/// Checks them. Throws Failure(bad_input).
pictures::Look look_of(const LookOptions& options);

}  // namespace pupflow::cli
