// Where a pup is and how it is turned, recorded for observers.
//
//   centre     = mean over the points of x
//   quaternion = of the proper rotation nearest to the sum over the points of x q^T
//
// with the rest offsets q: the rotation of shape matching, fitted to the points after the step.
#pragma once

#include "engine/cloud.h"
#include "engine/fit.h"
#include "engine/state.h"

namespace pupflow {

/// Fills the state's pose of one pup: `fit` is that of its points (fit.h), `rotation` the one
/// nearest to its linear part.
template <class Real>
void record_pose(const ModeMatrix& fit, const Eigen::Matrix3d& rotation, State<Real>& state,
                 int pup);

/// Fits first. Fills the state's poses of the pups first ... last - 1; there must be room (make_room).
template <class Real>
void record_poses(const Cloud<Real>& cloud, State<Real>& state, int first, int last);

}  // namespace pupflow
