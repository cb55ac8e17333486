#include "engine/shape_match.h"

#include <algorithm>
#include <cmath>

#include "engine/elementary.h"

namespace pupflow {
namespace {

constexpr double kLargestVolumeFactor = 3;

double determinant(const Eigen::Matrix3d& a) {
  return a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) -
         a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
         a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
}

double volume_factor(double det) {
  constexpr double kSmallest =
      1 / (kLargestVolumeFactor * kLargestVolumeFactor * kLargestVolumeFactor);
  const double size = std::abs(det);
  return size > kSmallest ? std::min(inverse_cbrt_fixed(size), kLargestVolumeFactor)
                          : kLargestVolumeFactor;
}

int mode_count(bool quadratic) {
  return 1 + kLinearModes + (quadratic ? kQuadraticModes : 0);
}

template <class Real>
Real* position_row(State<Real>& state, int axis, int pup) {
  AlignedVector<Real>* component[3] = {&state.x, &state.y, &state.z};
  return component[axis]->data() + state.row(pup);
}

template <class Real>
Real* velocity_row(State<Real>& state, int axis, int pup) {
  AlignedVector<Real>* component[3] = {&state.vx, &state.vy, &state.vz};
  return component[axis]->data() + state.row(pup);
}

}  // namespace

template <class Real>
ModeMatrix fit_modes(const Cloud<Real>& cloud, const State<Real>& state, int pup, bool quadratic) {
  const std::size_t row = state.row(pup);
  const Real* xyz[3] = {state.x.data() + row, state.y.data() + row, state.z.data() + row};
  const int modes = mode_count(quadratic);
  Real sums[kModes][3];
  state.kernels->fit(cloud.mode.data(), modes, cloud.stride, xyz, sums);
  ModeMatrix fit = ModeMatrix::Zero();
  for (int m = 0; m < modes; ++m) {
    for (int axis = 0; axis < 3; ++axis) fit(axis, m) = static_cast<double>(sums[m][axis]);
  }
  return fit;
}

ModeMatrix goal_modes(const ModeMatrix& fit, double linear_scale, double beta, RotationKind& kind) {
  ModeMatrix goal = beta * fit;
  const Eigen::Matrix3d linear = fit.middleCols<kLinearModes>(1);
  const Rotation rotation = nearest_rotation(linear);
  kind = rotation.kind;
  // The fitted linear map of rest offsets is linear / linear_scale, the rotation's is R.
  Eigen::Matrix3d map = (beta / linear_scale) * linear + (1 - beta) * rotation.matrix;
  if (beta > 0) map *= volume_factor(determinant(map));
  goal.middleCols<kLinearModes>(1) = linear_scale * map;
  goal.col(kMeanMode) = fit.col(kMeanMode);
  return goal;
}

template <class Real>
void predict(const Params& params, State<Real>& state, int pup) {
  double push[3] = {0, 0, -params.gravity};
  if (params.drive > 0) {
    const SinCos direction = sincos_fixed(state.heading[pup]);
    push[0] = params.drive * direction.cos;
    push[1] = params.drive * direction.sin;
  }
  for (int axis = 0; axis < 3; ++axis) {
    state.kernels->predict(static_cast<Real>(params.dt), static_cast<Real>(params.dt * push[axis]),
                           state.stride, position_row(state, axis, pup),
                           velocity_row(state, axis, pup));
  }
}

template <class Real>
RotationKind match_shape(const Params& params, bool quadratic, const Cloud<Real>& cloud,
                         State<Real>& state, int pup) {
  const ModeMatrix fit = fit_modes(cloud, state, pup, quadratic);
  RotationKind kind = RotationKind::regular;
  const ModeMatrix goal = goal_modes(fit, cloud.linear_scale, params.beta, kind);
  const bool moves = params.integrator == Integrator::predictive;
  const Real position_share = moves ? static_cast<Real>(params.alpha) : Real(0);
  const Real velocity_share = static_cast<Real>(params.alpha / params.dt);
  for (int axis = 0; axis < 3; ++axis) {
    Real row[kModes];
    for (int m = 0; m < kModes; ++m) row[m] = static_cast<Real>(goal(axis, m));
    state.kernels->pull(cloud.mode.data(), mode_count(quadratic), cloud.stride, row, position_share,
                        velocity_share, position_row(state, axis, pup),
                        velocity_row(state, axis, pup));
  }
  return kind;
}

#define PUPFLOW_INSTANTIATE(Real)                                                                \
  template ModeMatrix fit_modes<Real>(const Cloud<Real>&, const State<Real>&, int, bool);        \
  template void predict<Real>(const Params&, State<Real>&, int);                                 \
  template RotationKind match_shape<Real>(const Params&, bool, const Cloud<Real>&, State<Real>&, \
                                          int);
PUPFLOW_INSTANTIATE(float)
PUPFLOW_INSTANTIATE(double)
#undef PUPFLOW_INSTANTIATE

}  // namespace pupflow
