#include "pupflow/snapshot.h"

namespace pupflow {

Params params_of_step(const Params& recipe, std::int64_t step) {
  Params params = recipe;
  if (step > 0) apply_schedule(recipe, step - 1, params);
  return params;
}

LitterView Snapshot::view() const {
  const int pups = params.pups, points = points_per_pup(params);
  PartSet kept;  // of what the last step recorded a snapshot holds the contacts alone
  for (const Part part : {Part::exposure, Part::owners, Part::pairs}) {
    if (recorded.has(part)) kept.add(part);
  }
  return {.params = in_force,
          .recipe = params,
          .pups = pups,
          .points = points,
          .positions = PointVectors(std::span<const double>(positions), pups, points),
          .velocities = PointVectors(std::span<const double>(velocities), pups, points),
          .tb = body_temperature,
          .felt_tb = felt_tb,
          .heading = heading,
          .exposed = exposed,
          .t_left = {},
          .t_right = {},
          .turn = {},
          .pose = {},
          .touched = touched,
          .left = {},
          .strain = {},
          .touching = touching,
          .step = step,
          .time = clock.at(step, in_force.dt),
          .recorded = kept};
}

}  // namespace pupflow
