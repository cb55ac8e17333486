// A litter as the engine's arrays, for measuring parts of a step by themselves.
#pragma once

#include "engine/state.h"

namespace pupflow::bench {

/// Positions, velocities and bounds of a snapshot whose numbers fit its parameters.
template <class Real>
State<Real> state_of(const Snapshot& snapshot);

}  // namespace pupflow::bench
