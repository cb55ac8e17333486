// Projection of a pup's points, or of their velocities, on the deformation modes.
//
// The modes of cloud.h are orthonormal over the points, so the coefficients of the best fit are
//
//   c_m = sum over the points i of mode_m(i) (p_i - p_0)
//
// with mode_m = 1/n for the mean.
#pragma once

#include <Eigen/Core>

#include "engine/cloud.h"
#include "engine/state.h"

namespace pupflow {

/// Coefficients on the modes, one column each. Column 0 is the mean, relative to the pup's first
/// point: small numbers keep their digits wherever in the arena the pup is.
using ModeMatrix = Eigen::Matrix<double, 3, kModes>;

/// Coefficients of a pup's positions on the mean, the linear and, if `quadratic`, the quadratic
/// modes. Columns that are left out are 0.
template <class Real>
ModeMatrix fit_modes(const Cloud<Real>& cloud, const State<Real>& state, int pup, bool quadratic);

/// The same for velocities.
template <class Real>
ModeMatrix fit_velocity_modes(const Cloud<Real>& cloud, const State<Real>& state, int pup,
                              bool quadratic);

/// The linear part of a fit: Cloud::linear_scale times the linear map that fits the rest offsets
/// best.
inline Eigen::Matrix3d linear_part(const ModeMatrix& fit) {
  return fit.middleCols<kLinearModes>(1);
}

}  // namespace pupflow
