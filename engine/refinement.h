// What refining the time step means: the body that a step of dt moves.
//
// alpha acts per step, so the paper's step h0 = 0.01 is part of its model. refinement = naive takes
// alpha as it is, whatever dt: a smaller dt is then a stiffer body. refinement = consistent keeps
// what a deformation mode does in a second. At h0 a step multiplies a mode by lambda = (1 - alpha)
// + i sqrt(alpha (1 - alpha)); at dt = s h0 it must be lambda^s. With D = |lambda|^(2 s) and Tr = 2
// Re lambda^s that takes the rigidity a = 1 - Tr + D, and the deformation part of the velocity must
// be multiplied by kappa = D / (Tr - D) before predicting. At s = 1, a = alpha and kappa = 1: the
// paper's model. As s -> 0 a mode d goes to d'' + 2 gamma d' + (gamma^2 + omega^2) d = 0 with gamma
// = -ln(1 - alpha) / (2 h0), omega = arccos sqrt(1 - alpha) / h0. (Derived for this program; docs/
// model.md, Refining the time step. Macklin et al. 2019, Small Steps in Physics Simulation, has why
// position-based stiffness depends on the step.)
//
// With integrator = explicit a mode has |lambda| = 1: kappa = 1, a = 2 - 2 cos(s phi), cos phi = 1
// - alpha / 2.
#pragma once

#include <Eigen/Core>

#include "engine/modes.h"
#include "pupflow/parameters.h"

namespace pupflow {

/// What one step does to a body. Modes that the fit can represent see the rigidity alpha (1 -
/// beta), all others, and the volume, which the fit is scaled to hold, see alpha: two classes with
/// a rigidity and a kappa each.
struct StepBody {
  double alpha, beta;        // for shape matching, in place of the parameters'
  double keep_fitted = 1;    // kappa of the fitted modes' velocity
  double keep_rest = 1;      // kappa of all other deformation's
  double contact_share = 1;  // factor on the displacement by contacts
  bool damps() const { return keep_fitted != 1 || keep_rest != 1; }
};

/// The body of a step of `params.dt`. `params` are sound: with Refinement::consistent dt is at most
/// the reference step, and alpha = 1, whose modes stop within one step and so have no limit, does
/// not come with a smaller one.
StepBody step_body(const Params& params);

/// Coefficients on the modes of cloud.h, one column each. Column 0 is the mean, relative to the
/// pup's first point: small numbers keep their digits wherever in the arena the pup is.
using ModeMatrix = Eigen::Matrix<double, 3, kModes>;

/// The velocity w that a fitted velocity `v` of the shape `x` is damped towards: v <- v + (1 -
/// keep_rest)(w - v) multiplies the deformation part of a velocity by the kappas of `body`, also
/// the part that the fit cannot represent. The rigid part, mean velocity and spin of the fitted
/// shape, stays: momentum and angular momentum of that shape are kept to rounding. Modes that the
/// body does not fit are 0 in w.
ModeMatrix damping_goal(const StepBody& body, const ModeMatrix& x, const ModeMatrix& v);

}  // namespace pupflow
