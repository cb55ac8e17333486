// The rest shape of a pup: points spread over a sphere, and the modes in which it can deform.
//
// Shape matching with quadratic terms (Mueller 2005, sec. 4.3) fits the nine monomials
// q = (x, y, z, x^2, y^2, z^2, xy, yz, zx) of the rest offsets, less their means. On a sphere
// x^2 + y^2 + z^2 is constant, so they span eight dimensions: the real spherical harmonics of
// degree 1 and 2. The points keep the symmetry of the cube, which makes those eight orthogonal over
// the points, too. Scaled to unit length they turn (sum q q^T)^+ into the identity: no inverse is
// needed, and in float nothing has to be cut off by a tolerance.
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
  int stride = 0;  // stride_for(points), lanes.h; padding has weight 0 in every mode
  /// Mode m at point i: mode[m * stride + i]. The mean mode is 1/n; sums over the points of the
  /// product of two other modes are 1 or 0.
  AlignedVector<Real> mode;
  /// Linear mode = rest offset / linear_scale; linear_scale^2 = sum of x^2 over the points.
  double linear_scale = 1;

  const Real* mode_row(int m) const { return mode.data() + static_cast<std::size_t>(m) * stride; }
};

/// The cloud of `rest` offsets, which must have the symmetry of `cube_sphere`.
template <class Real>
Cloud<Real> make_cloud(const std::vector<Eigen::Vector3d>& rest);

}  // namespace pupflow
