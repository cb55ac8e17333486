#include "engine/refinement.h"

#include <cassert>
#include <cmath>

#include "engine/elementary.h"

namespace pupflow {
namespace {

/// Rigidity and kappa of one class of modes.
struct ModeClass {
  double rigidity, keep;
};

/// a and kappa of refinement.h for a rigidity `alpha` per step of h0 and dt = s h0, in forms in
/// which nothing cancels at small s.
ModeClass mode_class(Integrator integrator, double alpha, double s) {
  if (integrator == Integrator::explicit_) {
    // From cos(phi) = 1 - alpha / 2 and the half-angle formulas
    //
    //   sin^2(phi / 2) = (1 - cos(phi)) / 2 = alpha / 4
    //   cos^2(phi / 2) = (1 + cos(phi)) / 2 = 1 - alpha / 4
    //
    //   a = 2 - 2 cos(s phi) = 4 sin^2(s phi / 2)
    const double phi = 2 * atan2_fixed(std::sqrt(alpha) / 2, std::sqrt(1 - alpha / 4));
    const double sine = sincos_fixed(s * phi / 2).sin;
    return {4 * sine * sine, 1};
  }
  // With r = |lambda|^s = (1 - alpha)^(s/2), Tr = 2 r cos(s phi) and D = r^2. Let
  //
  //   less = r - 1
  //   bend = 2 - 2 cos(s phi) = 4 sin^2(s phi / 2)
  //
  //   a = 1 - 2 r cos(s phi) + r^2
  //     = (1 - r)^2 + 2 r (1 - cos(s phi))
  //     = less^2 + r bend
  //
  //   kappa = r^2 / (2 r cos(s phi) - r^2)
  //         = r / (2 cos(s phi) - r)
  //         = r / (1 - less - bend)
  const double log_r = log_fixed(1 - alpha) / 2;
  const double phi = atan2_fixed(std::sqrt(alpha), std::sqrt(1 - alpha));
  const double r = exp_fixed(s * log_r), less = expm1_fixed(s * log_r);
  const SinCos half = sincos_fixed(s * phi / 2);
  const double bend = 4 * half.sin * half.sin;
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

/// The spin omega and the growth g of the shape `x` with the velocity `v`, both on the modes, the
/// first `modes` of them. They minimise
///
///   sum over points of |v - omega x r - g r|^2
///
/// where r is a point's place relative to the mean. The modes are orthonormal over the points, so
/// sums over points are sums over the columns x_m and v_m. Setting the derivatives to 0 gives
///
///   I omega = L,    I = sum (|x_m|^2 - x_m x_m^T),    L = sum x_m x v_m
///   g = sum x_m . v_m / sum |x_m|^2
///
/// where growth has no part in L and spin none in g. I is symmetric with the rows i_0, i_1, i_2, so
/// by Cramer's rule
///
///   det(I) = i_0 . (i_1 x i_2)
///   omega  = (L_0 i_1 x i_2 + L_1 i_2 x i_0 + L_2 i_0 x i_1) / det(I)
///
/// A shape without extent, or on a line, gets no spin: there it cannot be told from deformation.
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
  assert(s > 0 && s < 1);
  assert(params.rigidity < 1 || params.integrator == Integrator::explicit_);
  const ModeClass rest = mode_class(params.integrator, params.rigidity, s);
  const ModeClass fitted =
      mode_class(params.integrator, params.rigidity * (1 - params.deformation), s);
  StepBody body{rest.rigidity, params.deformation, fitted.keep, rest.keep, s};
  // In shape matching the fitted modes have the rigidity body.alpha (1 - body.beta), which must be
  // that of their class.
  if (rest.rigidity > 0) body.beta = 1 - fitted.rigidity / rest.rigidity;
  return body;
}

ModeMatrix damping_goal(const StepBody& body, const ModeMatrix& x, const ModeMatrix& v) {
  assert(body.damps() && body.keep_rest != 1);
  // The modes that the scene fits, not those of the plan: forced quadratic modes would change the
  // spin.
  const int modes = mode_count(body.beta > 0);
  const Motion motion = motion_of(x, v, modes);
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
