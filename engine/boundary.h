// Stage 1 of a step: the arena's floor and wall.
//
// Floor, where z - r < 0: v_z <- |v_z|, z <- r. Then wall, where (|x| + r)^2 + (|y| + r)^2 > R^2,
// with the inward normal w = (-cos phi, -sin phi, 0) and phi = atan2(y, x): v <- (v + w) / 2, p <-
// p + h v. r is the point radius, R the arena's, h the time step. Wilson 2017, Methods.
#pragma once

#include "engine/state.h"
#include "pupflow/parameters.h"

namespace pupflow {

/// Applies floor and wall to one pup where its bounds reach them, and keeps the bounds true.
template <class Real>
void apply_boundaries(const Params& params, State<Real>& state, int pup);

}  // namespace pupflow
