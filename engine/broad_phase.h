// Which pups are near enough to touch: no pair is searched point by point unless its bounds meet.
#pragma once

#include <vector>

#include "engine/state.h"

namespace pupflow {

/// Finds pairs of overlapping boxes by sorting them along one axis and sweeping (Baraff 1992): the
/// axis along which the litter is longest, be it a carpet or a column. Keeps its memory between
/// calls, so that a step allocates nothing.
template <class Real>
class BroadPhase {
 public:
  /// All pairs whose boxes are at most `margin` apart along every axis, sorted. Boxes must be
  /// finite.
  const std::vector<TouchingPair>& find(const std::vector<Bounds<Real>>& boxes, Real margin);

 private:
  void sort_along_axis(const std::vector<Bounds<Real>>& boxes);
  void sort_pairs(int pups);

  int axis_ = 0;
  std::vector<int> order_;
  std::vector<int> bucket_;
  std::vector<TouchingPair> found_, pairs_;
};

}  // namespace pupflow
