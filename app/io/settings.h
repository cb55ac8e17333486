// From what the user typed to one sound parameter set: default < scene or earlier output < --set <
// --seed, --steps, --precision.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pupflow/parameters.h"

namespace pupflow::io {

/// What the user typed.
struct Settings {
  std::string scene;                // a path or a shipped name; empty for none
  std::string like;                 // an output file whose parameters to take; empty for none
  std::optional<std::int64_t> row;  // of `like`, a table of runs
  std::vector<std::string> sets;    // "name=value" each
  std::vector<std::string> at;      // "step=800,ta=0.2" each: changes, beside those of the scene
  std::optional<std::string> seed, steps, precision, flow_lag;

  bool empty() const;  // nothing was typed
};

/// What it comes to.
struct Setup {
  Params params;
  std::string title, description;  // of the scene; empty without one
};

/// Applies `settings` to `base` in their order and checks the whole set. Throws Failure: bad_input
/// with every problem, one a line; bad_file when a file cannot be read.
Setup set_up(const Settings& settings, const Params& base = {});

}  // namespace pupflow::io
