// The summary at the end of `run`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "pupflow/observer.h"
#include "pupflow/overlap.h"
#include "pupflow/simulation.h"

namespace pupflow::cli {

/// Declares --celsius, for verbs that print a summary.
void add_celsius(CLI::App& verb, bool& celsius);

/// A few words about the litter of `params`, e.g. for a first line; T_a also in degrees if `celsius`.
std::string litter_words(const Params& params, bool celsius = false);

/// Overlap is measured once in so many steps, since that takes as long as about ten steps.
constexpr int kOverlapEvery = 10;

/// The measurements of a run.
struct Seen {
  const RunMeans& means;
  std::optional<Overlap> overlap;  // means; empty where it was not measured
};

/// What `run_summary` says as one JSON object, with every digit.
std::string run_json(const std::string& title, const Simulation& simulation, const Seen& seen,
                     double seconds);

/// The run's means (or why there are none), status, warnings, hash and speed. `seconds` is its wall
/// time; with `celsius` temperatures are there in degrees, too.
std::string run_summary(const std::string& title, const Simulation& simulation, const Seen& seen,
                        double seconds, bool celsius);

}  // namespace pupflow::cli
