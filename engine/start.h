// The litter at t = 0.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/state.h"
#include "pupflow/geometry.h"
#include "pupflow/parameters.h"

namespace pupflow {

/// Puts `rest` offsets, turned at random, round `start_centres` (geometry.h); at rest, at T_b(0),
/// with random courses.
template <class Real>
void lay_out(const Params& params, const std::vector<Eigen::Vector3d>& rest, State<Real>& state);

}  // namespace pupflow
