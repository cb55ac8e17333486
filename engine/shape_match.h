// Stage 5 of a step: motion under gravity and drive, and shape matching.
//
// Predict: v* = v + h f, x* = x + h v*, with the acceleration f = (drive cos theta, drive sin
// theta, -g). Match: A = sum (x* - x*_cm) q^T over the nine quadratic monomials q of the rest
// offsets (cloud.h), B = A (sum q q^T)^+, R the proper rotation nearest to A's linear part, T =
// beta B + (1 - beta)[R 0 0], its linear part scaled by min(|det|^(-1/3), 3), near beta = 1 by at
// most 1/beta, to hold the volume; goals g = T q + x*_cm; x <- x* + alpha (g - x*), v <- v* + alpha
// (g - x*)/h. Mueller, Heidelberger, Teschner & Gross 2005, secs. 3.3, 4.2, 4.3; Wilson 2017,
// Methods.
//
// v is the same number as (x(t+h) - x(t))/h but keeps its digits at small h. With integrator =
// explicit the goals are those of x(t), as the paper writes it: match first, velocities only, then
// predict.
//
// A refined step (refinement.h) damps the deformation part of the velocity before it predicts, v <-
// v + s (w - v) with s = 1 - keep_rest and w linear in the fits of x(t) and v. Prediction and fit
// are linear, too: with p and u the points and velocities predicted without damping,
//
//   fit(x*) = fit(p) + h s (w - fit(u)),    fit(x(t)) = fit(p) - h fit(u)
//   d = alpha (g - p) + h s (1 - alpha) (w - u),    x(t+h) = p + d,    v(t+h) = u + d/h
//
// relative to the first point. So damping costs one more fit, that of the velocities, and no pass
// of its own.
#pragma once

#include <Eigen/Core>
#include <array>

#include "engine/cloud.h"
#include "engine/refinement.h"
#include "engine/rotation.h"
#include "engine/state.h"
#include "pupflow/parameters.h"

namespace pupflow {

/// Projection of a pup's points on the mean, the linear and, if `quadratic`, the quadratic modes
/// (else those columns are 0).
template <class Real>
ModeMatrix fit_modes(const Cloud<Real>& cloud, const State<Real>& state, int pup, bool quadratic);

/// The same of its points' velocities.
template <class Real>
ModeMatrix fit_velocity_modes(const Cloud<Real>& cloud, const State<Real>& state, int pup,
                              bool quadratic);

/// The linear part of a fit: a multiple of the linear map that fits the rest offsets best.
inline Eigen::Matrix3d linear_part(const ModeMatrix& fit) {
  return fit.middleCols<kLinearModes>(1);
}

/// Coefficients of the goals for a fit and the rotation of its linear part: the mean is kept, the
/// rest is T. With beta = 1 any finite `rotation` gives the same bits.
ModeMatrix goal_modes(const ModeMatrix& fit, const Eigen::Matrix3d& rotation, double linear_scale,
                      double beta);

/// The fits of one pup that goals are made from.
struct BodyFit {
  ModeMatrix shape;     // of x*, its velocity damped
  ModeMatrix velocity;  // w, to which damping draws; not set unless body.damps()
};
template <class Real>
BodyFit fit_body(const Params& params, const StepBody& body, bool quadratic,
                 const Cloud<Real>& cloud, const State<Real>& state, int pup);

/// Draws one pup's points by the share body.alpha towards the goals that `goal` describes, and
/// damps its velocity where body.damps().
template <class Real>
void pull_to_goals(const Params& params, const StepBody& body, bool quadratic,
                   const Cloud<Real>& cloud, const BodyFit& fit, const ModeMatrix& goal,
                   State<Real>& state, int pup);

/// v <- v + h f, x <- x + h v for one pup.
template <class Real>
void predict(const Params& params, State<Real>& state, int pup);

/// What goals are made of: with beta = 0 nothing of the quadratic modes, with beta = 1 nothing of
/// the rotation.
struct MatchParts {
  bool quadratic = true, rotation = true;
  bool strain = false;  // record each point's distance from its goal
};

/// Pulls one pup's points towards their goals: fit, nearest rotation, goals, pull. Returns how the
/// rotation was found: regular, where none was looked for. `parts.strain` fills the state's strain,
/// which must have room (make_room), before the pull.
template <class Real>
RotationKind match_shape(const Params& params, const StepBody& body, MatchParts parts,
                         const Cloud<Real>& cloud, State<Real>& state, int pup);

}  // namespace pupflow
