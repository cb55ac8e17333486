// The rest shape of a pup: points spread over a sphere, and the modes in which it can deform.
//
// Shape matching with quadratic terms (Mueller 2005, sec. 4.3) fits nine monomials of the rest
// offsets (x, y, z), less their means:
//
//   q = (x, y, z, x^2, y^2, z^2, xy, yz, zx)
//
// On a sphere x^2 + y^2 + z^2 is constant, so they span eight dimensions: the real spherical
// harmonics of degree 1 and 2,
//
//   x, y, z,    x^2 - y^2,  2 z^2 - x^2 - y^2,  xy,  yz,  zx
//
// The points have the symmetry of the cube, so these eight are orthogonal over the points, too.
// Scaled to unit length they are the modes. In this basis
//
//   sum over points of q q^T = identity
//
// so no inverse is needed and, in float, no tolerance for small eigenvalues.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/aligned.h"
#include "engine/modes.h"
#include "pupflow/geometry.h"

namespace pupflow {

/// The modes of a rest shape, ready for the kernels; shared by all pups of a litter.
template <class Real>
struct Cloud {
  int points = 0;
  int stride = 0;  // stride_for(points), lanes.h; every mode is 0 in the padding
  /// Mode m at point i: mode[m * stride + i]. The mean mode is 1/n. The sum over the points of the
  /// product of two other modes is 1 for equal modes, 0 for different ones.
  AlignedVector<Real> mode;
  /// linear mode = rest offset / linear_scale
  /// linear_scale^2 = sum over points of x^2
  double linear_scale = 1;

  const Real* mode_row(int m) const { return mode.data() + static_cast<std::size_t>(m) * stride; }
};

/// The cloud of `rest` offsets, which must have the symmetry of `cube_sphere`: that of the cube,
/// and offset n/2 + i is minus offset i, to the bit.
template <class Real>
Cloud<Real> make_cloud(const std::vector<Eigen::Vector3d>& rest);

}  // namespace pupflow
