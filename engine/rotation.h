// The proper rotation nearest to a matrix: the R of shape matching.
#pragma once

#include <Eigen/Core>

namespace pupflow {

/// How sure the rotation is.
enum class RotationKind {
  regular,   // the matrix keeps orientation and is far from flat: Newton's iteration
  fallback,  // flat or mirrored: from singular values, still the one nearest rotation
  arbitrary  // a line, a point or not finite: many rotations are as near, one of them is returned
};

struct Rotation {
  Eigen::Matrix3d matrix;  // orthogonal to rounding, det +1, whatever came in
  RotationKind kind;
};

/// argmin over R in SO(3) of |R - a| (Frobenius), for any `a`. The regular case takes Newton's
/// iteration for the polar factor with Frobenius scaling (Higham 1986, SIAM J. Sci. Stat. Comput.
/// 7, 1160), the others one-sided Jacobi singular values with the sign of the smallest turned where
/// needed (Umeyama 1991). Independent of the scale of `a`.
Rotation nearest_rotation(const Eigen::Matrix3d& a);

}  // namespace pupflow
