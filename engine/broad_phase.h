// Which pups are near enough to touch: no pair is searched point by point unless its bounds meet.
#pragma once

#include <vector>

#include "engine/state.h"

namespace pupflow {

/// Finds pairs of overlapping boxes by sorting them along x and sweeping (Baraff 1992). Keeps its
/// memory between calls, so that a step allocates nothing.
template <class Real>
class BroadPhase {
 public:
  /// All pairs whose boxes are at most `margin` apart along every axis, sorted. Boxes must be
  /// finite.
  const std::vector<TouchingPair>& find(const std::vector<Bounds<Real>>& boxes, Real margin);

 private:
  std::vector<int> order_;
  std::vector<TouchingPair> pairs_;
};

}  // namespace pupflow
