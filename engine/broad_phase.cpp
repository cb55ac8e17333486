#include "engine/broad_phase.h"

#include <algorithm>
#include <numeric>

namespace pupflow {
namespace {

template <class Real>
bool near_along(const Bounds<Real>& a, const Bounds<Real>& b, int axis, Real margin) {
  return a.low[axis] <= b.high[axis] + margin && b.low[axis] <= a.high[axis] + margin;
}

}  // namespace

template <class Real>
const std::vector<TouchingPair>& BroadPhase<Real>::find(const std::vector<Bounds<Real>>& boxes,
                                                        Real margin) {
  if (order_.size() != boxes.size()) {
    order_.resize(boxes.size());
    std::iota(order_.begin(), order_.end(), 0);
  }
  // Insertion sort: the order is nearly right since the last step.
  for (std::size_t i = 1; i < order_.size(); ++i) {
    const int pup = order_[i];
    std::size_t j = i;
    for (; j > 0 && boxes[pup].low[0] < boxes[order_[j - 1]].low[0]; --j) order_[j] = order_[j - 1];
    order_[j] = pup;
  }
  pairs_.clear();
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const Bounds<Real>& a = boxes[order_[i]];
    for (std::size_t j = i + 1; j < order_.size(); ++j) {
      const Bounds<Real>& b = boxes[order_[j]];
      if (b.low[0] > a.high[0] + margin) break;
      if (!near_along(a, b, 1, margin) || !near_along(a, b, 2, margin)) continue;
      pairs_.push_back({std::min(order_[i], order_[j]), std::max(order_[i], order_[j])});
    }
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const TouchingPair& a, const TouchingPair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  });
  return pairs_;
}

template class BroadPhase<float>;
template class BroadPhase<double>;

}  // namespace pupflow
