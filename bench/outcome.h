// What a baseline shows after a step, for holding it against the engine.
#pragma once

#include <vector>

#include "pupflow/snapshot.h"

namespace pupflow::bench {

/// Shapes as in Snapshot: x0 y0 z0 x1 ..., pup by pup; then one value per pup; pairs sorted.
struct Outcome {
  std::vector<double> positions, velocities;
  std::vector<double> body_temperature, heading, exposed;
  std::vector<TouchingPair> touching;
};

}  // namespace pupflow::bench
