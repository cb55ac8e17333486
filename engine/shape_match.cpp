#include "engine/shape_match.h"

#include <algorithm>
#include <cmath>

#include "engine/elementary.h"
#include "engine/pack.h"

namespace pupflow {
namespace {

constexpr double kLargestVolumeFactor = 3;

/// Sums of component times mode for `Count` modes from `first` on, over the points of one pup.
/// Several modes at a time share the loads; how many does not change a bit of any sum.
template <int Count, class Real>
void fit_some(const Cloud<Real>& cloud, const Real* const position[3], const Real origin[3],
              int first, ModeMatrix& fit) {
  using P = Pack<Real>;
  P sum[Count][3];
  for (auto& mode : sum) mode[0] = mode[1] = mode[2] = P::zero();
  const P ox = P::broadcast(origin[0]), oy = P::broadcast(origin[1]), oz = P::broadcast(origin[2]);
  for (int i = 0; i < cloud.stride; i += kLanes<Real>) {
    const P x = P::load(position[0] + i) - ox;
    const P y = P::load(position[1] + i) - oy;
    const P z = P::load(position[2] + i) - oz;
    for (int m = 0; m < Count; ++m) {
      const P mode = P::load(cloud.mode_row(first + m) + i);
      sum[m][0] += mode * x;
      sum[m][1] += mode * y;
      sum[m][2] += mode * z;
    }
  }
  for (int m = 0; m < Count; ++m) {
    for (int axis = 0; axis < 3; ++axis) fit(axis, first + m) = sum[m][axis].sum();
  }
}

/// What one pass over a pup's points needs to draw them to their goals.
template <class Real>
struct Pull {
  Real goal[3][kModes];  // column 0: the centre, relative to the first point
  Real position_share;   // alpha, or 0 where only velocities change
  Real velocity_share;   // alpha / h
};

template <int Modes, class Real>
void pull_to_goals(const Cloud<Real>& cloud, const Pull<Real>& pull, int axis, Real* x, Real* v) {
  using P = Pack<Real>;
  P coefficient[Modes];
  for (int m = 0; m < Modes; ++m) coefficient[m] = P::broadcast(pull.goal[axis][m]);
  const P position_share = P::broadcast(pull.position_share);
  const P velocity_share = P::broadcast(pull.velocity_share);
  const P origin = P::broadcast(x[0]);
  for (int i = 0; i < cloud.stride; i += kLanes<Real>) {
    const P here = P::load(x + i);
    P to_goal = coefficient[0] - (here - origin);
    for (int m = 1; m < Modes; ++m) to_goal += coefficient[m] * P::load(cloud.mode_row(m) + i);
    (here + position_share * to_goal).store(x + i);
    (P::load(v + i) + velocity_share * to_goal).store(v + i);
  }
}

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

}  // namespace

template <class Real>
ModeMatrix fit_modes(const Cloud<Real>& cloud, const State<Real>& state, int pup, bool quadratic) {
  const std::size_t row = state.row(pup);
  const Real* position[3] = {state.x.data() + row, state.y.data() + row, state.z.data() + row};
  const Real origin[3] = {*position[0], *position[1], *position[2]};
  ModeMatrix fit = ModeMatrix::Zero();
  fit_some<2>(cloud, position, origin, 0, fit);
  fit_some<2>(cloud, position, origin, 2, fit);
  if (quadratic) {
    fit_some<2>(cloud, position, origin, 4, fit);
    fit_some<2>(cloud, position, origin, 6, fit);
    fit_some<1>(cloud, position, origin, 8, fit);
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
  using P = Pack<Real>;
  double push[3] = {0, 0, -params.gravity};
  if (params.drive > 0) {
    const SinCos direction = sincos_fixed(state.heading[pup]);
    push[0] = params.drive * direction.cos;
    push[1] = params.drive * direction.sin;
  }
  Real* component[3][2] = {{state.x.data(), state.vx.data()},
                           {state.y.data(), state.vy.data()},
                           {state.z.data(), state.vz.data()}};
  const P h = P::broadcast(static_cast<Real>(params.dt));
  for (int axis = 0; axis < 3; ++axis) {
    Real* x = component[axis][0] + state.row(pup);
    Real* v = component[axis][1] + state.row(pup);
    const P gain = P::broadcast(static_cast<Real>(params.dt * push[axis]));
    for (int i = 0; i < state.stride; i += kLanes<Real>) {
      const P faster = P::load(v + i) + gain;
      faster.store(v + i);
      (P::load(x + i) + h * faster).store(x + i);
    }
  }
}

template <class Real>
RotationKind match_shape(const Params& params, const Cloud<Real>& cloud, State<Real>& state,
                         int pup) {
  const bool quadratic = params.beta > 0;
  const ModeMatrix fit = fit_modes(cloud, state, pup, quadratic);
  RotationKind kind = RotationKind::regular;
  const ModeMatrix goal = goal_modes(fit, cloud.linear_scale, params.beta, kind);
  Pull<Real> pull;
  for (int axis = 0; axis < 3; ++axis) {
    for (int m = 0; m < kModes; ++m) pull.goal[axis][m] = static_cast<Real>(goal(axis, m));
  }
  const bool moves = params.integrator == Integrator::predictive;
  pull.position_share = moves ? static_cast<Real>(params.alpha) : Real(0);
  pull.velocity_share = static_cast<Real>(params.alpha / params.dt);
  AlignedVector<Real>* component[3][2] = {
      {&state.x, &state.vx}, {&state.y, &state.vy}, {&state.z, &state.vz}};
  for (int axis = 0; axis < 3; ++axis) {
    Real* x = component[axis][0]->data() + state.row(pup);
    Real* v = component[axis][1]->data() + state.row(pup);
    if (quadratic) {
      pull_to_goals<kModes>(cloud, pull, axis, x, v);
    } else {
      pull_to_goals<1 + kLinearModes>(cloud, pull, axis, x, v);
    }
  }
  return kind;
}

#define PUPFLOW_INSTANTIATE(Real)                                                         \
  template ModeMatrix fit_modes<Real>(const Cloud<Real>&, const State<Real>&, int, bool); \
  template void predict<Real>(const Params&, State<Real>&, int);                          \
  template RotationKind match_shape<Real>(const Params&, const Cloud<Real>&, State<Real>&, int);
PUPFLOW_INSTANTIATE(float)
PUPFLOW_INSTANTIATE(double)
#undef PUPFLOW_INSTANTIATE

}  // namespace pupflow
