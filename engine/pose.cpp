#include "engine/pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>

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
void record_pose(const ModeMatrix& fit, const Eigen::Matrix3d& rotation, State<Real>& state,
                 int pup) {
  const std::size_t origin = state.row(pup);  // the mean is relative to the first point
  const Real first[3] = {state.x[origin], state.y[origin], state.z[origin]};
  PupPose& pose = state.pose[pup];
  for (int axis = 0; axis < 3; ++axis) {
    pose.centre[axis] = static_cast<double>(first[axis]) + fit(axis, kMeanMode);
  }
  pose.quaternion = quaternion_of(rotation);
}

template <class Real>
void record_poses(const Cloud<Real>& cloud, State<Real>& state, int first, int last) {
  assert(0 <= first && last <= state.pups);
  ModeMatrix fit[kRotationLanes];
  Eigen::Matrix3d linear[kRotationLanes];
  Rotation rotation[kRotationLanes];
  for (int begin = first; begin < last; begin += kRotationLanes) {
    const int count = std::min(kRotationLanes, last - begin);
    for (int i = 0; i < count; ++i) {
      fit[i] = fit_modes(cloud, state, begin + i, false);
      linear[i] = linear_part(fit[i]);
    }
    nearest_rotations({linear, static_cast<std::size_t>(count)}, rotation);
    for (int i = 0; i < count; ++i) record_pose(fit[i], rotation[i].matrix, state, begin + i);
  }
}

template void record_pose<float>(const ModeMatrix&, const Eigen::Matrix3d&, State<float>&, int);
template void record_pose<double>(const ModeMatrix&, const Eigen::Matrix3d&, State<double>&, int);
template void record_poses<float>(const Cloud<float>&, State<float>&, int, int);
template void record_poses<double>(const Cloud<double>&, State<double>&, int, int);

}  // namespace pupflow
