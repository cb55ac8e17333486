// The litter at t = 0.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/state.h"
#include "pupflow/geometry.h"
#include "pupflow/parameters.h"

namespace pupflow {

/// Places every pup of `state` at its start: the `rest` offsets, in a random orientation, round its
/// centre (start_centres, geometry.h), with velocity 0, body temperature T_b(0) and a random
/// heading. `state` must be new (make_state), for as many pups as `params` has and as many points
/// as `rest`.
template <class Real>
void lay_out(const Params& params, const std::vector<Eigen::Vector3d>& rest, State<Real>& state);

}  // namespace pupflow
