// The arena's floor and wall.
//
// r is the point radius, R the arena radius, h the time step. Floor, where z - r < 0:
//
//   v_z <- |v_z|
//   z   <- r
//
// Then wall, where (|x| + r)^2 + (|y| + r)^2 > R^2, with the inward normal w:
//
//   phi = atan2(y, x)
//   w   = (-cos(phi), -sin(phi), 0)
//   v <- (v + w) / 2
//   p <- p + h v
//
// Wilson 2017, Methods.
#pragma once

#include "engine/state.h"
#include "pupflow/parameters.h"

namespace pupflow {

/// Applies floor and wall to one pup where its bounds reach them. Its bounds must be valid, that is
/// enclose its points, and are valid again afterwards.
template <class Real>
void apply_boundaries(const Params& params, State<Real>& state, int pup);

}  // namespace pupflow
