// Stage 3 of a step: heat.
//
// dT_b/dt = G - k1 A (T_b - T_a) - k2 (1 - A)(T_b - mean T_c), Wilson 2017 after Glancy et al.
// 2015; A is the exposed share of the surface and T_c what the touching afferents feel. The
// exchange term is absent when nothing touches. With A and T_c held over a step the equation is
// linear and solved exactly.
#pragma once

#include "engine/state.h"
#include "pupflow/parameters.h"
#include "pupflow/status.h"

namespace pupflow {

/// T_b after one step of `params.dt`, by `params.heat`. `exposed` is A; `contact_mean` the mean T_c
/// of the touching afferents, which only counts where exposed < 1 and k2 > 0. Rates may overflow:
/// the result is finite wherever the exact value of the step is.
double heat_step(const Params& params, double tb, double exposed, double contact_mean);

/// T_b of one pup after this step. It is not yet set: all pups change at once. Where k2 = 0 nothing
/// depends on the mean of the touched temperatures; without `with_mean` it is not worked out.
template <class Real>
Status heat(const Params& params, bool with_mean, const State<Real>& state, int pup, double& next);

}  // namespace pupflow
