// The broad phase of contact search: which pups are near enough to touch. Only the points of near
// pairs are compared with each other.
#pragma once

#include <vector>

#include "engine/state.h"

namespace pupflow {

/// Two pups whose boxes come near each other, first < second.
struct NearPair {
  int first, second;
  friend bool operator==(const NearPair&, const NearPair&) = default;
};

/// Finds near pairs by sorting the boxes along one axis and sweeping (Baraff 1992): the axis along
/// which the litter is longest. Its memory is kept between calls, so that a step allocates nothing.
template <class Real>
class BroadPhase {
 public:
  /// All pairs whose boxes are at most `margin` >= 0 apart along every axis, sorted by first and
  /// then second pup. In each box low <= high; it may be infinite but not NaN. The result is valid
  /// until the next call.
  const std::vector<NearPair>& near_pairs(const std::vector<Bounds<Real>>& boxes, Real margin);

 private:
  void sort_along_axis(const std::vector<Bounds<Real>>& boxes);
  void sort_pairs(int pups);

  int axis_ = 0;
  std::vector<int> order_;          // pups by box.low along axis_
  std::vector<int> bucket_;         // see sort_pairs
  std::vector<NearPair> unsorted_;  // in the order of the sweep
  std::vector<NearPair> pairs_;
};

}  // namespace pupflow
