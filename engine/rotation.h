// The proper rotation nearest to a matrix: the R of shape matching.
#pragma once

#include <Eigen/Core>
#include <span>

namespace pupflow {

/// How the rotation was found.
enum class RotationKind {
  regular,   // the matrix has a positive determinant and is far from flat: Newton's iteration
  fallback,  // flat or mirrored: from singular values; there is still one nearest rotation
  arbitrary  // a line, a point or not finite: one of many rotations that are equally near
};

struct Rotation {
  Eigen::Matrix3d matrix;  // orthogonal to rounding, det +1, for any input
  RotationKind kind;
};

/// The R in SO(3) with the least |R - a| (Frobenius norm), for any `a`. The regular case uses
/// Newton's iteration for the polar factor with Frobenius scaling (Higham 1986, SIAM J. Sci. Stat.
/// Comput. 7, 1160), the others one-sided Jacobi singular values, where the smallest one changes
/// its sign if det would be -1 (Umeyama 1991). The result does not depend on the scale of `a`.
Rotation nearest_rotation(const Eigen::Matrix3d& a);

/// The same for each of `a`, several at a time. `out` has room for as many. The bits do not depend
/// on which matrices are taken together.
void nearest_rotations(std::span<const Eigen::Matrix3d> a, Rotation* out);

}  // namespace pupflow
