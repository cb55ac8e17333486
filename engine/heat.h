// Body temperatures.
//
//   dT_b/dt = G - k1 A (T_b - T_a) - k2 (1 - A) (T_b - mean(T_c))
//
// A is the exposed share of the surface, T_c the temperature that a touching afferent feels. Where
// nothing touches there is no exchange term. Wilson 2017 after Glancy et al. 2015.
//
// With A and T_c held over a step the equation is linear, and heat = exact takes its solution:
//
//   k        = k1 A + k2 (1 - A)
//   T_b(t+h) = T_b + (1 - e^(-k h)) / k  dT_b/dt
//
// heat = euler takes one forward Euler step:
//
//   T_b(t+h) = T_b + h dT_b/dt
#pragma once

#include "engine/state.h"
#include "pupflow/parameters.h"
#include "pupflow/status.h"

namespace pupflow {

/// T_b after one step of `params.dt`, by `params.heat`. `exposed` is A, `heating` is added to G. `contact_mean` is the mean
/// T_c of the touching afferents and matters only where exposed < 1 and k2 > 0. Rates may overflow:
/// the result is finite wherever the exact value of the step is.
double heat_step(const Params& params, double tb, double exposed, double contact_mean,
                 double heating = 0);

/// T_b of one pup after this step goes to `next`, since all pups change at once. Without
/// `with_mean` the mean of T_c is not computed; it may be false where k2 = 0 or there is one pup.
template <class Real>
Status heat(const Params& params, bool with_mean, const State<Real>& state, int pup, double& next);

}  // namespace pupflow
