// What refining the time step means: the body that a step of dt moves.
//
// Rigidity alpha acts per step, so the paper's step h0 = 0.01 s is part of its model. refinement =
// naive takes alpha as it is, whatever dt: a smaller dt then gives a stiffer body. refinement =
// consistent keeps the motion of a deformation mode per second. It chooses the rigidity a and the
// velocity factor kappa of a step of dt = s h0, s <= 1, as follows. (Derived for this program;
// docs/model.md, Refining the time step. Macklin et al. 2019, Small Steps in Physics Simulation,
// explain why position-based stiffness depends on the step.)
//
// One mode has the amplitude d and the velocity v; let u = h v. Its goal is d = 0. With
// integrator = predictive one step predicts d + u and goes the share alpha towards 0:
//
//   d' = (1 - alpha) (d + u)
//   u' = d' - d
//
// The matrix of this step, from (d, u) to (d', u'), is
//
//   M = [ 1 - alpha   1 - alpha ]        trace(M) = 2 (1 - alpha)
//       [ -alpha      1 - alpha ]        det(M)   = 1 - alpha
//
// Its eigenvalues are the roots of lambda^2 - trace(M) lambda + det(M) = 0:
//
//   lambda   = (1 - alpha) +- i sqrt(alpha (1 - alpha))  =  |lambda| e^(+- i phi)
//   |lambda| = sqrt(1 - alpha)
//   tan(phi) = sqrt(alpha) / sqrt(1 - alpha)
//
// The refined step has the same form with a for alpha, and multiplies the velocity by kappa before
// it predicts:
//
//   d' = (1 - a) (d + kappa u)
//   u' = d' - d
//
//   trace = (1 - a) (1 + kappa)
//   det   = (1 - a) kappa
//
// 1/s such steps must do what one step of h0 does, so the eigenvalues must be lambda^s:
//
//   (1 - a) (1 + kappa) = Tr = 2 Re(lambda^s) = 2 |lambda|^s cos(s phi)
//   (1 - a) kappa       = D  = |lambda|^(2 s)
//
// The difference of both lines gives 1 - a = Tr - D, and then
//
//   a     = 1 - Tr + D
//   kappa = D / (Tr - D)
//
// For s = 1, Tr - D = 2 (1 - alpha) - (1 - alpha), so a = alpha and kappa = 1: the paper's model.
// For s -> 0, lambda^(t/h0) = e^((-gamma +- i omega) t), so the mode follows
//
//   d'' + 2 gamma d' + (gamma^2 + omega^2) d = 0
//
//   gamma = -ln(1 - alpha) / (2 h0)
//   omega = phi / h0
//
// With integrator = explicit the goals are those of d, not of d + u:
//
//   u' = u - alpha d
//   d' = d + u'
//
//   trace = 2 - alpha
//   det   = 1
//
// So |lambda| = 1 and 2 cos(phi) = 2 - alpha. The refined step keeps kappa = 1 and has the
// eigenvalues lambda^s where its trace 2 - a is 2 cos(s phi):
//
//   a = 2 - 2 cos(s phi)
//
// Contacts displace a point by a fixed amount per step, so a step of dt takes the share s of it.
#pragma once

#include "engine/fit.h"
#include "pupflow/parameters.h"

namespace pupflow {

/// What one step does to a body. There are two classes of modes, each with its rigidity and kappa.
/// Modes that the fit can represent have the rigidity alpha (1 - beta). All others, and the volume,
/// which the fit is scaled to hold, have alpha.
struct StepBody {
  double alpha, beta;        // for shape matching, in place of the parameters'
  double keep_fitted = 1;    // kappa of the fitted modes
  double keep_rest = 1;      // kappa of all other deformation
  double contact_share = 1;  // factor on the displacement by contacts, s
  bool damps() const { return keep_fitted != 1 || keep_rest != 1; }
};

/// The body of a step of `params.dt`. `params` are sound (`check`). With Refinement::consistent
/// that means dt <= h0; and alpha < 1 where dt < h0 and integrator = predictive, since alpha = 1
/// stops a mode within one step, which has no finer form.
StepBody step_body(const Params& params);

/// The velocity w towards which damping pulls the fitted velocity `v` of the shape `x`, both on the
/// modes. With kappa_f = keep_fitted and kappa_r = keep_rest, and a velocity
///
///   v = rigid + growth + distortion
///
/// (mean and spin of the fitted shape; its uniform growth; everything else), damping must give
///
///   v' = rigid + kappa_r growth + kappa_f distortion     in the fitted modes
///   v' = kappa_r v                                       in all others
///
/// shape_match.h applies one factor to all points: v' = v + (1 - kappa_r) (w - v). Therefore
///
///   w = v - growth - (1 - kappa_f) / (1 - kappa_r) distortion     in the fitted modes
///   w = 0                                                         in all others
///
/// Momentum and angular momentum of the fitted shape are kept to rounding. body.damps() must hold.
ModeMatrix damping_goal(const StepBody& body, const ModeMatrix& x, const ModeMatrix& v);

}  // namespace pupflow
