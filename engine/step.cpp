#include "engine/step.h"

#include <array>

#include "engine/boundary.h"
#include "engine/health.h"
#include "engine/shape_match.h"
#include "engine/taxis.h"

namespace pupflow {
namespace {

/// After the last stage that moved points: bounds for the next step, and a look for bad numbers.
template <class Real>
Status finish_motion(const Params& params, State<Real>& state, Stage stage) {
  const double suspect = kSuspectRadii * params.pup_radius;
  for (int pup = 0; pup < state.pups; ++pup) {
    const bool finite = update_bounds(state, pup);
    const Bounds<Real>& box = state.bounds[pup];
    bool small = true;
    for (int axis = 0; axis < 3; ++axis) {
      small = small &&
              static_cast<double>(box.high[axis]) - static_cast<double>(box.low[axis]) < suspect;
    }
    if (finite && small) continue;
    const Status status = inspect_pup(state, pup, params.pup_radius, stage);
    if (!status.ok()) return status;
  }
  return {};
}

template <class Real>
Status move(const Params& params, State<Real>& state, bool last) {
  for (int pup = 0; pup < state.pups; ++pup) predict(params, state, pup);
  return last ? finish_motion(params, state, Stage::predict) : Status{};
}

template <class Real>
Status match(const Params& params, bool quadratic, const Cloud<Real>& cloud, State<Real>& state,
             StepCounters& counters, bool last) {
  for (int pup = 0; pup < state.pups; ++pup) {
    const RotationKind kind = match_shape(params, quadratic, cloud, state, pup);
    counters.rotation_fallbacks += kind == RotationKind::regular ? 0 : 1;
  }
  return last ? finish_motion(params, state, Stage::shape_match) : Status{};
}

}  // namespace

template <class Real>
Status step_litter(const Params& params, const Plan& plan, const Cloud<Real>& cloud,
                   State<Real>& state, Workspace<Real>& workspace, StepCounters& counters,
                   StageListener* listener) {
  const bool predict_first = params.integrator == Integrator::predictive;
  const bool predict_last = !predict_first || !plan.has(Stage::shape_match);
  const std::array<Stage, kStageCount> order{
      Stage::boundary,
      Stage::contact,
      Stage::steering,
      Stage::heat,
      predict_first ? Stage::predict : Stage::shape_match,
      predict_first ? Stage::shape_match : Stage::predict,
  };
  for (const Stage stage : order) {
    if (!plan.has(stage)) continue;
    if (listener != nullptr) listener->stage_begins(stage);
    Status status;
    switch (stage) {
      case Stage::boundary:
        apply_boundaries(params, state);
        break;
      case Stage::contact:
        status = workspace.contacts.resolve(params, plan.afferents, state);
        break;
      case Stage::steering:
        status = steer(params, cloud, state);
        break;
      case Stage::heat:
        status = workspace.heat.apply(params, state);
        break;
      case Stage::predict:
        status = move(params, state, predict_last);
        break;
      case Stage::shape_match:
        status = match(params, plan.quadratic, cloud, state, counters, predict_first);
        break;
    }
    if (listener != nullptr) listener->stage_ends(stage);
    if (!status.ok()) return status;
  }
  ++state.step;
  return {};
}

#define PUPFLOW_INSTANTIATE(Real)                                                                 \
  template Status step_litter<Real>(const Params&, const Plan&, const Cloud<Real>&, State<Real>&, \
                                    Workspace<Real>&, StepCounters&, StageListener*);
PUPFLOW_INSTANTIATE(float)
PUPFLOW_INSTANTIATE(double)
#undef PUPFLOW_INSTANTIATE

}  // namespace pupflow
