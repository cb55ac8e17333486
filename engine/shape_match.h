// Motion under gravity and drive (predict), and shape matching.
//
// Predict, with the acceleration f:
//
//   f  = (drive cos(theta), drive sin(theta), -g)
//   v* = v + h f
//   x* = x + h v*
//
// Match, with the nine quadratic monomials q of the rest offsets (cloud.h):
//
//   A = sum over points of (x* - x*_cm) q^T
//   B = A (sum over points of q q^T)^+
//   R = the proper rotation nearest to the linear part of A
//   T = beta B + (1 - beta) [R 0 0]
//
// The linear part of T is scaled to hold the volume, by the factor
//
//   min(|det|^(-1/3), limit),    limit = 3       for beta <= 0.9
//                                limit = 1/beta  for beta >= 0.95, linear in between
//
// and the points are pulled towards the goals by the share alpha:
//
//   goal = T q + x*_cm
//   x <- x* + alpha (goal - x*)
//   v <- v* + alpha (goal - x*) / h
//
// Mueller, Heidelberger, Teschner & Gross 2005, secs. 3.3, 4.2, 4.3; Wilson 2017, Methods.
//
// v is the same number as (x(t+h) - x(t)) / h but keeps its digits at small h. With integrator =
// explicit the goals are those of x(t), as the paper writes it: the match comes first and changes
// velocities only, then the points move.
//
// A refined step (refinement.h) damps the deformation part of the velocity before it predicts:
//
//   v <- v + c (w - v),    c = 1 - keep_rest
//
// where w is linear in the fits of x(t) and v. Prediction and fit are linear, too. With p and u the
// points and velocities predicted without damping, therefore
//
//   x*        = p + h c (w - u)
//   fit(x*)   = fit(p) + h c (w - fit(u))
//   fit(x(t)) = fit(p) - h fit(u)
//
// relative to the first point, where gravity and drive, which are the same for all points, drop
// out. The step with damping is then
//
//   d      = x(t+h) - p
//          = (x* - p) + alpha (goal - x*)
//          = alpha (goal - p) + h c (1 - alpha) (w - u)
//   x(t+h) = p + d
//   v(t+h) = u + d / h
//
// So damping needs one more fit, that of the velocities, and no pass of its own.
#pragma once

#include "engine/fit.h"
#include "engine/refinement.h"
#include "engine/rotation.h"
#include "engine/state.h"
#include "pupflow/parameters.h"

namespace pupflow {

/// Coefficients of the goals for a fit and the rotation of its linear part: the mean of the fit,
/// and T. With beta = 1 any finite `rotation` gives the same bits.
ModeMatrix goal_modes(const ModeMatrix& fit, const Eigen::Matrix3d& rotation, double linear_scale,
                      double beta);

/// The fits of one pup from which its goals are made.
struct BodyFit {
  ModeMatrix shape;     // fit(x*), with damping where body.damps()
  ModeMatrix velocity;  // w, towards which damping pulls; not set unless body.damps()
};
template <class Real>
BodyFit fit_body(const Params& params, const StepBody& body, bool quadratic,
                 const Cloud<Real>& cloud, const State<Real>& state, int pup);

/// Pulls one pup's points by the share body.alpha towards the goals with the coefficients `goal`,
/// and damps its velocity where body.damps().
template <class Real>
void pull_to_goals(const Params& params, const StepBody& body, bool quadratic,
                   const Cloud<Real>& cloud, const BodyFit& fit, const ModeMatrix& goal,
                   State<Real>& state, int pup);

/// v <- v + h f, x <- x + h v for one pup; f is gravity, drive and the force that acts on it.
template <class Real>
void predict(const Params& params, State<Real>& state, int pup);

/// What the goals are made from. With beta = 0 they need no quadratic modes, with beta = 1 no
/// rotation.
struct MatchParts {
  bool quadratic = true, rotation = true;
  bool strain = false;  // record each point's distance from its goal
  bool pose = false;    // record where the pup is and how it is turned; needs `rotation`, the
                        // predictive integrator, and a step without damping
};

/// Pups that are matched together at most.
constexpr int kMatchedTogether = kRotationLanes;

/// Pulls the points of the pups first ... last - 1, at most kMatchedTogether, towards their goals:
/// fits, nearest rotations, goals, pull. Returns how many rotations were not RotationKind::regular.
/// `parts.strain` fills the state's strain before the pull; it must have room (make_room).
///
/// `parts.pose` fills the state's poses. The pull leaves both as they are: goals have the mean of
/// the points, and their linear part is R times a symmetric matrix like that of the fit.
template <class Real>
int match_shapes(const Params& params, const StepBody& body, MatchParts parts,
                 const Cloud<Real>& cloud, State<Real>& state, int first, int last);

}  // namespace pupflow
