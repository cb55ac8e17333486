#include "engine/shape_match.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/elementary.h"
#include "engine/pose.h"

namespace pupflow {
namespace {

/// The largest volume factor: 3 up to beta = 0.9, 1/beta from beta = 0.95 on, linear in between.
/// The goals contain beta times the fit. With factor * beta <= 1, a body that is kept flat cannot
/// grow in its other directions from step to step.
double largest_volume_factor(double beta) {
  constexpr double kUsual = 3, kBegin = 0.9, kEnd = 0.95;
  if (beta <= kBegin) return kUsual;
  const double share = std::min((beta - kBegin) / (kEnd - kBegin), 1.0);
  return kUsual + share * (1 / beta - kUsual);
}

double determinant(const Eigen::Matrix3d& a) {
  return a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) -
         a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
         a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
}

double volume_factor(double det, double beta) {
  const double largest = largest_volume_factor(beta);
  const double smallest = 1 / (largest * largest * largest);
  const double size = std::abs(det);
  return size > smallest ? std::min(inverse_cbrt_fixed(size), largest) : largest;
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

/// One row of a mode matrix in a kernel's precision.
template <class Real>
struct ModeRow {
  Real value[kModes];
  ModeRow(const ModeMatrix& matrix, int axis) {
    for (int m = 0; m < kModes; ++m) value[m] = static_cast<Real>(matrix(axis, m));
  }
};

}  // namespace

ModeMatrix goal_modes(const ModeMatrix& fit, const Eigen::Matrix3d& rotation, double linear_scale,
                      double beta) {
  assert(linear_scale > 0);
  ModeMatrix goal = beta * fit;
  // The fitted linear map of rest offsets is linear / linear_scale, the rotation's is R.
  Eigen::Matrix3d map = (beta / linear_scale) * linear_part(fit) + (1 - beta) * rotation;
  if (beta == 1) map.array() += 0.0;  // turns -0 into 0: the sign of 0 R must not matter
  if (beta > 0) map *= volume_factor(determinant(map), beta);
  goal.middleCols<kLinearModes>(1) = linear_scale * map;
  goal.col(kMeanMode) = fit.col(kMeanMode);
  return goal;
}

template <class Real>
void predict(const Params& params, State<Real>& state, int pup) {
  double acceleration[3] = {0, 0, -params.gravity};
  if (params.drive > 0) {
    const SinCos direction = sincos_fixed(state.heading[pup]);
    acceleration[0] = params.drive * direction.cos;
    acceleration[1] = params.drive * direction.sin;
  }
  if (!state.actions.empty()) {
    for (int axis = 0; axis < 3; ++axis) acceleration[axis] += state.actions[pup].force[axis];
  }
  for (int axis = 0; axis < 3; ++axis) {
    state.kernels->predict(static_cast<Real>(params.dt),
                           static_cast<Real>(params.dt * acceleration[axis]), state.points,
                           position_row(state, axis, pup), velocity_row(state, axis, pup));
  }
}

template <class Real>
BodyFit fit_body(const Params& params, const StepBody& body, bool quadratic,
                 const Cloud<Real>& cloud, const State<Real>& state, int pup) {
  BodyFit fit;
  fit.shape = fit_modes(cloud, state, pup, quadratic);
  if (!body.damps()) return fit;
  const ModeMatrix speed = fit_velocity_modes(cloud, state, pup, quadratic);
  fit.velocity = damping_goal(body, fit.shape - params.dt * speed, speed);
  fit.shape += (params.dt * (1 - body.keep_rest)) * (fit.velocity - speed);
  return fit;
}

template <class Real>
void pull_to_goals(const Params& params, const StepBody& body, bool quadratic,
                   const Cloud<Real>& cloud, const BodyFit& fit, const ModeMatrix& goal,
                   State<Real>& state, int pup) {
  assert(pup >= 0 && pup < state.pups);
  assert(cloud.points == state.points && cloud.stride == state.stride);
  const bool moves = params.integrator == Integrator::predictive;
  const auto alpha = static_cast<Real>(body.alpha);
  const auto drag = static_cast<Real>(params.dt * (1 - body.keep_rest) * (1 - body.alpha));
  // The goals are multiplied by the factors as the kernel has them, rounded to Real. Otherwise
  // rounding would damp rigid motion, too.
  const ModeMatrix sum =
      body.damps()
          ? ModeMatrix(static_cast<double>(alpha) * goal + static_cast<double>(drag) * fit.velocity)
          : goal;
  for (int axis = 0; axis < 3; ++axis) {
    const ModeRow<Real> row(sum, axis);
    Real* const x = position_row(state, axis, pup);
    Real* const v = velocity_row(state, axis, pup);
    const Real* const modes = cloud.mode.data();
    const int count = mode_count(quadratic);
    if (body.damps()) {
      state.kernels->pull_damped(modes, count, cloud.points, cloud.stride, row.value, alpha, drag,
                                 static_cast<Real>(1 / params.dt), x, v);
    } else {
      state.kernels->pull(modes, count, cloud.points, cloud.stride, row.value,
                          moves ? alpha : Real(0), static_cast<Real>(body.alpha / params.dt), x, v);
    }
  }
}

/// Distance of each point of a pup from the goal that `goal` describes.
template <class Real>
static void record_strain(const Cloud<Real>& cloud, const ModeMatrix& goal, State<Real>& state,
                          int pup) {
  const std::size_t row = state.row(pup);
  const Real* xyz[3] = {state.x.data() + row, state.y.data() + row, state.z.data() + row};
  float* const strain = state.strain.data() + state.flat(pup);
  for (int i = 0; i < state.points; ++i) {
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      double apart = goal(axis, kMeanMode) - static_cast<double>(xyz[axis][i] - xyz[axis][0]);
      for (int m = 1; m < kModes; ++m) {
        apart += goal(axis, m) * static_cast<double>(cloud.mode_row(m)[i]);
      }
      squared += apart * apart;
    }
    strain[i] = static_cast<float>(std::sqrt(squared));
  }
}

template <class Real>
int match_shapes(const Params& params, const StepBody& body, MatchParts parts,
                 const Cloud<Real>& cloud, State<Real>& state, int first, int last) {
  const int count = last - first;
  assert(count > 0 && count <= kMatchedTogether);
  BodyFit fit[kMatchedTogether];
  Eigen::Matrix3d linear[kMatchedTogether];
  Rotation rotation[kMatchedTogether];
  for (int i = 0; i < count; ++i) {
    fit[i] = fit_body(params, body, parts.quadratic, cloud, state, first + i);
    linear[i] = linear_part(fit[i].shape);
    rotation[i] = {Eigen::Matrix3d::Zero(), RotationKind::regular};
  }
  if (parts.rotation) nearest_rotations({linear, static_cast<std::size_t>(count)}, rotation);
  int irregular = 0;
  for (int i = 0; i < count; ++i) {
    irregular += rotation[i].kind == RotationKind::regular ? 0 : 1;
    const ModeMatrix goal =
        goal_modes(fit[i].shape, rotation[i].matrix, cloud.linear_scale, body.beta);
    if (parts.strain) record_strain(cloud, goal, state, first + i);
    if (parts.pose) record_pose(fit[i].shape, rotation[i].matrix, state, first + i);
    pull_to_goals(params, body, parts.quadratic, cloud, fit[i], goal, state, first + i);
  }
  return irregular;
}

#define PUPFLOW_INSTANTIATE(Real)                                                                 \
  template void predict<Real>(const Params&, State<Real>&, int);                                  \
  template BodyFit fit_body<Real>(const Params&, const StepBody&, bool, const Cloud<Real>&,       \
                                  const State<Real>&, int);                                       \
  template void pull_to_goals<Real>(const Params&, const StepBody&, bool, const Cloud<Real>&,     \
                                    const BodyFit&, const ModeMatrix&, State<Real>&, int);        \
  template int match_shapes<Real>(const Params&, const StepBody&, MatchParts, const Cloud<Real>&, \
                                  State<Real>&, int, int);
PUPFLOW_INSTANTIATE(float)
PUPFLOW_INSTANTIATE(double)
#undef PUPFLOW_INSTANTIATE

}  // namespace pupflow
