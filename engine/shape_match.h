// Stage 5 of a step: motion under gravity and drive, and shape matching.
//
// Predict: v* = v + h f, x* = x + h v*, with the acceleration f = (drive cos theta, drive sin
// theta, -g). Match: A = sum (x* - x*_cm) q^T over the nine quadratic monomials q of the rest
// offsets (cloud.h), B = A (sum q q^T)^+, R the proper rotation nearest to A's linear part, T =
// beta B + (1 - beta)[R 0 0], its linear part scaled by min(|det|^(-1/3), 3) to hold the volume;
// goals g = T q + x*_cm; x <- x* + alpha (g - x*), v <- v* + alpha (g - x*)/h. Mueller,
// Heidelberger, Teschner & Gross 2005, secs. 3.3, 4.2, 4.3; Wilson 2017, Methods.
//
// v is the same number as (x(t+h) - x(t))/h but keeps its digits at small h. With integrator =
// explicit the goals are those of x(t), as the paper writes it: match first, velocities only, then
// predict.
#pragma once

#include <Eigen/Core>
#include <array>

#include "engine/cloud.h"
#include "engine/params.h"
#include "engine/rotation.h"
#include "engine/state.h"

namespace pupflow {

/// Coefficients on the modes of cloud.h, one column each. Column 0 is the mean, relative to the
/// pup's first point: small numbers keep their digits wherever in the arena the pup is.
using ModeMatrix = Eigen::Matrix<double, 3, kModes>;

/// Projection of a pup's points on the mean, the linear and, if `quadratic`, the quadratic modes
/// (else those columns are 0).
template <class Real>
ModeMatrix fit_modes(const Cloud<Real>& cloud, const State<Real>& state, int pup, bool quadratic);

/// Coefficients of the goals for a fit: the mean is kept, the rest is T. `kind` tells how the
/// rotation was found.
ModeMatrix goal_modes(const ModeMatrix& fit, double linear_scale, double beta, RotationKind& kind);

/// v <- v + h f, x <- x + h v for one pup.
template <class Real>
void predict(const Params& params, State<Real>& state, int pup);

/// Draws one pup's points towards their goals, fitted with or without the quadratic modes. Returns
/// how the rotation was found.
template <class Real>
RotationKind match_shape(const Params& params, bool quadratic, const Cloud<Real>& cloud,
                         State<Real>& state, int pup);

}  // namespace pupflow
