// Where numbers became infinite, NaN or far too large.
#pragma once

#include "engine/state.h"
#include "pupflow/parameters.h"
#include "pupflow/status.h"

namespace pupflow {

/// A point further than this many pup radii from its pup's centre has diverged.
constexpr double kDivergedRadii = 100;

/// A pup is inspected point by point when it was displaced, or its box is longer, than this many
/// pup radii. None is missed: a point can only have diverged when a side of its pup's box is longer
/// than kDivergedRadii / sqrt(3) pup radii.
constexpr double kSuspectRadii = 50;

/// The first point of `pup` whose position or velocity is not finite. Fine when there is none. The
/// status names `stage` and the step that is being taken.
template <class Real>
Status find_non_finite(const State<Real>& state, int pup, Stage stage);

/// Looks at every point of `pup`: the first that is not finite, else the first that has diverged.
/// Fine when there is none.
template <class Real>
Status inspect_pup(const State<Real>& state, int pup, double pup_radius, Stage stage);

/// What is wrong with a pup after its last motion in a step. Updates its bounds, and inspects its
/// points only where the bounds are suspect. A pup all of whose points are further than
/// kDivergedRadii pup radii beyond the wall has escaped: the wall halves a velocity and adds 1/2
/// inwards, so a drive above 2 / (3 h) is stronger than the wall, and without this check the status
/// would stay fine.
template <class Real>
Status check_motion(const Params& params, State<Real>& state, int pup, Stage stage);

}  // namespace pupflow
