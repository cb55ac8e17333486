// Helpers for tests that set up and look at litters: those of engine/bodies.h under the names that
// the tests use.
#pragma once

#include "engine/bodies.h"

namespace pupflow::testing {

using pupflow::place;
using pupflow::Points;
using pupflow::to_numbers;
using pupflow::to_points;

inline Points all_positions(const Simulation& s) {
  return of_all(s.view().positions);
}

inline Points all_velocities(const Simulation& s) {
  return of_all(s.view().velocities);
}

inline Points of_pup(const Simulation& s, int pup, const Points& all) {
  return Points(all.begin() + static_cast<std::ptrdiff_t>(pup) * s.points(),
                all.begin() + static_cast<std::ptrdiff_t>(pup + 1) * s.points());
}

inline Params weightless() {
  return weightless_pup();
}

}  // namespace pupflow::testing
