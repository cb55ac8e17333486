// One step of a litter: the planned stages, in order.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/cloud.h"
#include "engine/contact.h"
#include "engine/state.h"
#include "engine/team.h"
#include "pupflow/parameters.h"
#include "pupflow/plan.h"
#include "pupflow/status.h"

namespace pupflow {

/// Counts what a step had to do beyond the usual.
struct StepCounters {
  std::int64_t rotation_fallbacks = 0;  // rotations that were not RotationKind::regular
  std::int64_t searched_pairs = 0;      // pairs of pups that were searched point by point
};

/// Working memory of the stages, and the threads that share them; holds nothing that the next step
/// depends on.
template <class Real>
struct Workspace {
  /// What one worker met in its pups.
  struct alignas(64) Found {
    Status status;          // of the earliest stage, there of the lowest pup
    std::size_t place = 0;  // of that stage in the step
    StepCounters counters;
  };
  Contacts<Real> contacts;
  std::vector<Found> found;  // one per worker
  Team team;
};

/// t -> t + dt. The result has the same bits for every size of the team. A bad status is that of
/// the earliest stage and there of the lowest pup; the step's work is done to its end all the same,
/// but the step is not counted.
template <class Real>
Status step_litter(const Params& params, const Plan& plan, const Cloud<Real>& cloud,
                   State<Real>& state, Workspace<Real>& workspace, StepCounters& counters,
                   StageListener* listener);

}  // namespace pupflow
