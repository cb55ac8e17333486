// The two formulas of a step that concern a pup as a whole, as one would write them down; both
// baselines use them. The C library's functions, not the engine's.
#pragma once

#include "pupflow/parameters.h"

namespace pupflow::bench {

/// Throws std::invalid_argument unless `params` ask for what the baselines step: heading = course,
/// integrator = predictive, heat = exact, refinement = naive, beta at most 0.9.
void require_baseline_model(const Params& params);

/// The turn atan(v (S_L - S_R) / (S_L + S_R)) of a pup of temperature `tb` that feels `left` and
/// `right`. Wilson 2017, Methods; docs/model.md, 3.
double turn_of(const Params& params, double tb, double left, double right);

/// `tb` one step later: the solution of dT/dt = G - k1 A (T - T_a) - k2 (1 - A)(T - T_c), whose
/// last term is absent when A = 1. docs/model.md, 4.
double warmed(const Params& params, double tb, double exposed, double touched_mean);

/// `radians` within (-pi, pi].
double wrapped(double radians);

}  // namespace pupflow::bench
