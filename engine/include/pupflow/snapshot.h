// A litter's whole state as plain numbers, for files: what copying a Simulation keeps in memory.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pupflow/export.h"
#include "pupflow/parameters.h"
#include "pupflow/view.h"

namespace pupflow PUPFLOW_PUBLIC {

/// The step and the time at which dt last changed. Time is counted from there, in one product,
/// since adding up dt step by step would gather rounding errors.
struct Clock {
  std::int64_t step = 0;
  double time = 0;
  double at(std::int64_t now, double dt) const {
    return time + static_cast<double>(now - step) * dt;
  }
};

/// The parameters with which a run of `recipe` takes its step number `step`; those of the start for
/// step 0.
Params params_of_step(const Params& recipe, std::int64_t step);

/// Everything that the future depends on, and the contacts that the last step found. Positions and
/// velocities are x0 y0 z0 x1 ..., pup by pup; float litters widen to double exactly. A simulation
/// made from a snapshot goes on bit for bit like the one it was taken from.
struct Snapshot {
  Params params;    // of the start, with the schedule: the recipe of the run
  Params in_force;  // those of the last step, params_of_step(params, step)
  std::vector<double> positions, velocities;                        // 3 * pups * points
  std::vector<double> body_temperature, felt_tb, heading, exposed;  // one per pup
  std::vector<int> touched;                                         // pups * points
  std::vector<TouchingPair> touching;
  std::vector<Action> actions;  // set from outside, one per pup; empty: none
  std::int64_t step = 0;
  Clock clock;
  std::optional<std::int64_t> edited;  // the step after which somebody first set pups by hand:
                                       // the recipe alone does not make this litter
  PartSet recorded = kContactRecords;  // those of them that the last step recorded

  /// What it shows. Valid as long as the snapshot is. The sizes must fit the parameters.
  LitterView view() const;
};

}  // namespace PUPFLOW_PUBLIC
