// The litter at t = 0.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/params.h"
#include "engine/state.h"

namespace pupflow {

/// Where the pups' centres start. column (Wilson 2017): pup j at (r_x, r_y, j + r_pup + r_point),
/// with r_x and r_y uniform within start_spread; the paper's height is r_pup + r_point lower, which
/// would put pup 0 under the floor. carpet: a jittered hexagonal grid over the arena floor, in as
/// few layers as fit, a little above rest height. Each pup draws from a random stream of its own.
std::vector<Eigen::Vector3d> start_centres(const Params& params);

/// Puts `rest` offsets, turned at random, round those centres; at rest, at T_b(0), with random
/// courses.
template <class Real>
void lay_out(const Params& params, const std::vector<Eigen::Vector3d>& rest, State<Real>& state);

}  // namespace pupflow
