// What `run` tells people at its end.
#pragma once

#include <string>

#include "engine/metrics.h"
#include "engine/simulation.h"

namespace pupflow::cli {

/// A few words about the litter of `params`, e.g. for a first line.
std::string litter_words(const Params& params);

/// The run's means (or why there are none), status, warnings, hash and speed; `seconds` is the time
/// it took.
std::string run_summary(const std::string& title, const Simulation& simulation,
                        const RunMeans& means, double seconds);

}  // namespace pupflow::cli
