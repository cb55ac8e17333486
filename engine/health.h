// Finding out where numbers went wrong, once something looks wrong.
#pragma once

#include "engine/state.h"
#include "pupflow/parameters.h"
#include "pupflow/status.h"

namespace pupflow {

/// A point further than this many pup radii from its pup's centre has diverged.
constexpr double kDivergedRadii = 100;

/// A displacement or extent of a pup beyond this many pup radii is worth an inspection: a point can
/// only have diverged when its pup's box is longer than kDivergedRadii / sqrt(3).
constexpr double kSuspectRadii = 50;

/// The first point of `pup` whose position or velocity is not finite. Fine when there is none.
/// `stage` goes into the status, with the step that is under way.
template <class Real>
Status find_non_finite(const State<Real>& state, int pup, Stage stage);

/// Looks at every point of `pup`: the first that is not finite, else the first that has diverged.
/// Fine when there is none.
template <class Real>
Status inspect_pup(const State<Real>& state, int pup, double pup_radius, Stage stage);

/// What is wrong with a pup after its last motion in a step; makes its bounds true. Costs no more
/// than the bounds as long as they look right. A pup all of whose points are further than
/// kDivergedRadii pup radii beyond the wall has escaped: the wall halves a velocity and adds 1/2
/// inwards, so a drive above 2 / (3 h) outruns it, and the litter would seem fine for ever.
template <class Real>
Status check_motion(const Params& params, State<Real>& state, int pup, Stage stage);

}  // namespace pupflow
