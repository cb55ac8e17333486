// Finding out where numbers went wrong, once something looks wrong.
#pragma once

#include "engine/state.h"
#include "engine/status.h"

namespace pupflow {

/// A point further than this many pup radii from its pup's centre has diverged.
constexpr double kDivergedRadii = 100;

/// A displacement or extent of a pup beyond this many pup radii is worth an inspection: a point can
/// only have diverged when its pup's box is longer than kDivergedRadii / sqrt(3).
constexpr double kSuspectRadii = 50;

/// Looks at every point of `pup`: the first that is not finite, else the first that has diverged.
/// Fine when there is none. `stage` goes into the status, with the step that is under way.
template <class Real>
Status inspect_pup(const State<Real>& state, int pup, double pup_radius, Stage stage);

}  // namespace pupflow
