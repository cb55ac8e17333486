#include "engine/refinement.h"

#include <cmath>

#include "engine/elementary.h"

namespace pupflow {
namespace {

/// Rigidity and kappa of one class of modes.
struct ModeClass {
  double rigidity, keep;
};

ModeClass mode_class(Integrator integrator, double alpha, double s) {
  if (integrator == Integrator::explicit_) {
    const double phi = 2 * atan2_fixed(std::sqrt(alpha) / 2, std::sqrt(1 - alpha / 4));
    const double sine = sincos_fixed(s * phi / 2).sin;
    return {4 * sine * sine, 1};
  }
  // lambda = r e^(i phi). In these forms nothing cancels at small s.
  const double log_r = log_fixed(1 - alpha) / 2;
  const double phi = atan2_fixed(std::sqrt(alpha), std::sqrt(1 - alpha));
  const double r = exp_fixed(s * log_r), less = expm1_fixed(s * log_r);
  const SinCos half = sincos_fixed(s * phi / 2);
  const double bend = 4 * half.sin * half.sin;  // 2 - 2 cos(s phi)
  return {less * less + r * bend, r / (1 - less - bend)};
}

Eigen::Vector3d cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Spin and rate of growth that fit a velocity best.
struct Motion {
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();
  double growth = 0;
};

/// Of the shape with mode coefficients `x` that moves with `v`, the first `modes` of them:
/// inertia^-1 times angular momentum, and sum x v / sum x x. The modes have unit length, so sums
/// over points are sums over columns. A shape with no extent, or on a line, has no spin that could
/// be told from deformation.
Motion motion_of(const ModeMatrix& x, const ModeMatrix& v, int modes) {
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  double size = 0, work = 0;
  for (int m = 1; m < modes; ++m) {
    const Eigen::Vector3d at = x.col(m), speed = v.col(m);
    momentum += cross(at, speed);
    for (int i = 0; i < 3; ++i) {
      size += at[i] * at[i];
      work += at[i] * speed[i];
      for (int j = 0; j < 3; ++j) inertia(i, j) -= at[i] * at[j];
    }
  }
  Motion motion;
  if (!(size > 0)) return motion;
  motion.growth = work / size;
  for (int i = 0; i < 3; ++i) inertia(i, i) += size;
  const Eigen::Vector3d rows[3] = {inertia.col(0), inertia.col(1), inertia.col(2)};
  const Eigen::Vector3d c[3] = {cross(rows[1], rows[2]), cross(rows[2], rows[0]),
                                cross(rows[0], rows[1])};
  double det = 0;
  for (int i = 0; i < 3; ++i) det += rows[0][i] * c[0][i];
  if (!(det > 1e-9 * size * size * size)) return motion;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) motion.spin[i] += c[k][i] * momentum[k] / det;
  }
  return motion;
}

}  // namespace

StepBody step_body(const Params& params) {
  if (params.refinement == Refinement::naive || params.dt == kReferenceStep) {
    return {params.rigidity, params.deformation};
  }
  const double s = params.dt / kReferenceStep;
  const ModeClass rest = mode_class(params.integrator, params.rigidity, s);
  const ModeClass fitted =
      mode_class(params.integrator, params.rigidity * (1 - params.deformation), s);
  StepBody body{rest.rigidity, params.deformation, fitted.keep, rest.keep, s};
  // The fitted modes see alpha (1 - beta) of what shape matching is told.
  if (rest.rigidity > 0) body.beta = 1 - fitted.rigidity / rest.rigidity;
  return body;
}

ModeMatrix damping_goal(const StepBody& body, const ModeMatrix& x, const ModeMatrix& v) {
  // By what the scene fits, since other modes would see another spin: not by the plan, which may
  // have been forced.
  const int modes = 1 + kLinearModes + (body.beta > 0 ? kQuadraticModes : 0);
  const Motion motion = motion_of(x, v, modes);
  // All that is no deformation is kept: so the goal is v, less what the fitted modes lose beyond
  // the share 1 - keep_rest of the distance to the goal that all points go.
  const double fitted = (1 - body.keep_fitted) / (1 - body.keep_rest);
  ModeMatrix goal = ModeMatrix::Zero();
  goal.col(kMeanMode) = v.col(kMeanMode);
  for (int m = 1; m < modes; ++m) {
    const Eigen::Vector3d at = x.col(m), rigid = cross(motion.spin, at);
    for (int i = 0; i < 3; ++i) {
      const double growth = motion.growth * at[i];
      goal(i, m) = v(i, m) - (fitted * (v(i, m) - rigid[i] - growth) + growth);
    }
  }
  return goal;
}

}  // namespace pupflow
