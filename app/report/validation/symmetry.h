// The numbers of the pups and a mirror image should not change a litter, but they do.
#pragma once

#include "app/report/validation/runs.h"

namespace pupflow::report {

/// The litter of `simulation` with other numbers: pup j is its pup (5 j + 3) mod N. N must have no
/// factor 5.
Simulation relabelled(const Simulation& simulation);

/// The litter of `simulation` mirrored in the plane y = 0. Each body is mirrored in itself, too, by
/// a symmetry of its rest shape that keeps its first point, so that it is the same body, turned.
Simulation mirrored(const Simulation& simulation);

/// `simulation` with each pup above the floor, by 3 to 3.001 at random, so that no two
/// points are at the same height.
Simulation lifted(const Simulation& simulation);

/// The pup of the same litter that is pup `pup` of relabelled(that litter).
int pup_before(int pup, int pups);

/// After how many steps the centre of some pup j of `b` is further than 1e-6 from
/// `expected(a, j)`, where it is at first: `most` + 1 when that does not happen in `most` steps.
using Expected = std::function<Eigen::Vector3d(const Simulation& a, int pup)>;
std::int64_t steps_until_apart(Simulation a, Simulation b, const Expected& expected,
                               std::int64_t most);

}  // namespace pupflow::report
