/// @file
/// A litter's whole state as plain numbers, for files: what copying a Simulation keeps in memory.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pupflow/parameters.h"
#include "pupflow/view.h"

#pragma GCC visibility push(default)
namespace pupflow {

/// The step and the time at which dt last changed. Time is counted from there, in one product,
/// since adding up dt step by step would gather rounding errors.
struct Clock {
  std::int64_t step = 0;  ///< steps done when dt changed
  double time = 0;        ///< model seconds then

  /// The time after `now` steps, of which those since `step` are `dt` long.
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
  Params params;                         ///< of the start, with the schedule: the recipe of the run
  Params in_force;                       ///< those of the last step, params_of_step(params, step)
  std::vector<double> positions;         ///< 3 * pups * points; arena units
  std::vector<double> velocities;        ///< 3 * pups * points; arena units per second
  std::vector<double> body_temperature;  ///< T_b, one per pup
  std::vector<double> felt_tb;           ///< T_b before the last heat stage, one per pup
  std::vector<double> heading;           ///< theta, one per pup; radians
  std::vector<double> exposed;           ///< A, one per pup
  std::vector<int> touched;              ///< pups * points
  std::vector<TouchingPair> touching;    ///< sorted
  std::vector<Action> actions;           ///< set from outside, one per pup; empty: none
  std::int64_t step = 0;                 ///< steps done
  Clock clock;                           ///< from which the time follows
  std::optional<std::int64_t> edited;    ///< the step after which somebody first set pups by hand:
                                         ///< the recipe alone does not make this litter
  PartSet recorded = kContactRecords;    ///< those of them that the last step recorded

  /// What it shows. Valid as long as the snapshot is. The sizes must fit the parameters.
  LitterView view() const;
};

}  // namespace pupflow
#pragma GCC visibility pop
