// One step of a litter: the planned stages, in order.
#pragma once

#include "engine/cloud.h"
#include "engine/contact.h"
#include "engine/heat.h"
#include "engine/params.h"
#include "engine/plan.h"
#include "engine/state.h"
#include "engine/status.h"

namespace pupflow {

/// Told when a stage of a step begins and ends; the engine itself owns no clock.
class StageListener {
 public:
  virtual ~StageListener() = default;
  virtual void stage_begins(Stage stage) = 0;
  virtual void stage_ends(Stage stage) = 0;
};

/// Working memory of the stages; holds nothing that the next step depends on.
template <class Real>
struct Workspace {
  Contacts<Real> contacts;
  Heat<Real> heat;
};

/// Counts what a step had to do beyond the usual.
struct StepCounters {
  std::int64_t rotation_fallbacks = 0;  // rotations that were not RotationKind::regular
};

/// t -> t + dt. On a bad status the remaining stages and the step count are left as they are.
template <class Real>
Status step_litter(const Params& params, const Plan& plan, const Cloud<Real>& cloud,
                   State<Real>& state, Workspace<Real>& workspace, StepCounters& counters,
                   StageListener* listener);

}  // namespace pupflow
