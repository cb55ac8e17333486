// The litter at t = 0.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/params.h"
#include "engine/state.h"

namespace pupflow {

/// Where the pups' centres start. column (Wilson 2017): pup j at (r_x, r_y, s j + r_pup + r_point),
/// with r_x and r_y uniform within start_spread. The paper's height is r_pup + r_point lower, which
/// would put pup 0 under the floor. Its spacing is 1; s = max(1, 2 (r_pup + r_point)), so that
/// large pups do not begin inside each other. carpet: a jittered hexagonal grid over the arena
/// floor, in as few layers as fit, a little above rest height. Each pup draws from a random stream
/// of its own.
std::vector<Eigen::Vector3d> start_centres(const Params& params);

/// Puts `rest` offsets, turned at random, round those centres; at rest, at T_b(0), with random
/// courses.
template <class Real>
void lay_out(const Params& params, const std::vector<Eigen::Vector3d>& rest, State<Real>& state);

}  // namespace pupflow
