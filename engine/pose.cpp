#include "engine/pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>

#include "engine/fit.h"
#include "engine/rotation.h"

namespace pupflow {
namespace {

/// The same rotation has two quaternions; this is the one with w >= 0.
std::array<double, 4> quaternion_of(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  const double sign = q.w() < 0 ? -1 : 1;
  return {sign * q.x(), sign * q.y(), sign * q.z(), sign * q.w()};
}

}  // namespace

template <class Real>
void record_poses(const Cloud<Real>& cloud, State<Real>& state, int first, int last) {
  assert(0 <= first && last <= state.pups);
  Eigen::Matrix3d linear[kRotationLanes];
  Rotation rotation[kRotationLanes];
  for (int begin = first; begin < last; begin += kRotationLanes) {
    const int count = std::min(kRotationLanes, last - begin);
    for (int i = 0; i < count; ++i) {
      const ModeMatrix fit = fit_modes(cloud, state, begin + i, false);
      linear[i] = linear_part(fit);
      const std::size_t origin = state.row(begin + i);  // the mean is relative to the first point
      const Real xyz[3] = {state.x[origin], state.y[origin], state.z[origin]};
      for (int axis = 0; axis < 3; ++axis) {
        state.pose[begin + i].centre[axis] = static_cast<double>(xyz[axis]) + fit(axis, kMeanMode);
      }
    }
    nearest_rotations({linear, static_cast<std::size_t>(count)}, rotation);
    for (int i = 0; i < count; ++i) {
      state.pose[begin + i].quaternion = quaternion_of(rotation[i].matrix);
    }
  }
}

template void record_poses<float>(const Cloud<float>&, State<float>&, int, int);
template void record_poses<double>(const Cloud<double>&, State<double>&, int, int);

}  // namespace pupflow
