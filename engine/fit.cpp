#include "engine/fit.h"

#include <array>
#include <cassert>

namespace pupflow {
namespace {

template <class Real>
ModeMatrix fit(const Cloud<Real>& cloud, const State<Real>& state,
               const std::array<const AlignedVector<Real>*, 3>& component, int pup,
               bool quadratic) {
  assert(pup >= 0 && pup < state.pups);
  assert(cloud.points == state.points && cloud.stride == state.stride);
  const Real* xyz[3];
  for (std::size_t axis = 0; axis < 3; ++axis) xyz[axis] = component[axis]->data() + state.row(pup);
  const int modes = mode_count(quadratic);
  Real sums[kModes][3];
  state.kernels->fit(cloud.mode.data(), modes, cloud.points, cloud.stride, xyz, sums);
  ModeMatrix result = ModeMatrix::Zero();
  for (int m = 0; m < modes; ++m) {
    for (int axis = 0; axis < 3; ++axis) result(axis, m) = static_cast<double>(sums[m][axis]);
  }
  return result;
}

}  // namespace

template <class Real>
ModeMatrix fit_modes(const Cloud<Real>& cloud, const State<Real>& state, int pup, bool quadratic) {
  return fit(cloud, state, {&state.x, &state.y, &state.z}, pup, quadratic);
}

template <class Real>
ModeMatrix fit_velocity_modes(const Cloud<Real>& cloud, const State<Real>& state, int pup,
                              bool quadratic) {
  return fit(cloud, state, {&state.vx, &state.vy, &state.vz}, pup, quadratic);
}

#define PUPFLOW_INSTANTIATE(Real)                                                         \
  template ModeMatrix fit_modes<Real>(const Cloud<Real>&, const State<Real>&, int, bool); \
  template ModeMatrix fit_velocity_modes<Real>(const Cloud<Real>&, const State<Real>&, int, bool);
PUPFLOW_INSTANTIATE(float)
PUPFLOW_INSTANTIATE(double)
#undef PUPFLOW_INSTANTIATE

}  // namespace pupflow
