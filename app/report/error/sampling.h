// Running a scene of the error report: its steps are timed, and its state is looked at every 0.02 s.
#pragma once

#include <functional>

#include "app/report/error/scene.h"
#include "pupflow/simulation.h"

namespace pupflow::report {

/// Model seconds between samples. A whole number of steps of every setting fits into it.
constexpr double kSample = 0.02;

/// Processor time of the calling thread, in seconds.
double thread_seconds();

/// Adds one value to each quantity of the trajectory.
using Look = std::function<void(const LitterView&, Trajectory&)>;

/// Steps `simulation` through `samples` times kSample and calls `look` after each. `between`, if
/// given, edits the simulation after each step. Only the steps are timed. Throws
/// io::Failure(interrupted).
Outcome run_sampled(Simulation& simulation, int samples, std::size_t quantities, const Look& look,
                    const std::function<void(Simulation&)>& between = {});

}  // namespace pupflow::report
