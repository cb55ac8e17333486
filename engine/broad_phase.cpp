#include "engine/broad_phase.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "engine/invariants.h"

namespace pupflow {
namespace {

constexpr std::size_t kUsualPairs = 32;  // room per pup; with more pairs, memory is allocated

template <class Real>
bool near_along(const Bounds<Real>& a, const Bounds<Real>& b, int axis, Real margin) {
  return a.low[axis] <= b.high[axis] + margin && b.low[axis] <= a.high[axis] + margin;
}

/// The axis along which the boxes have the largest variance; `now` unless another has more than
/// four times its variance.
template <class Real>
int longest_axis(const std::vector<Bounds<Real>>& boxes, int now) {
  double spread[3];
  for (int axis = 0; axis < 3; ++axis) {
    double sum = 0, squares = 0;
    for (const Bounds<Real>& box : boxes) {
      const double place =
          static_cast<double>(box.low[axis]) - static_cast<double>(boxes[0].low[axis]);
      sum += place;
      squares += place * place;
    }
    spread[axis] = squares - sum * sum / static_cast<double>(boxes.size());
  }
  const int best = static_cast<int>(std::max_element(spread, spread + 3) - spread);
  return spread[best] > 4 * spread[now] ? best : now;
}

}  // namespace

template <class Real>
void BroadPhase<Real>::sort_along_axis(const std::vector<Bounds<Real>>& boxes) {
  const auto before = [&](int a, int b) { return boxes[a].low[axis_] < boxes[b].low[axis_]; };
  const int axis = boxes.empty() ? axis_ : longest_axis(boxes, axis_);
  if (order_.size() != boxes.size() || axis != axis_) {
    axis_ = axis;
    order_.resize(boxes.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), before);
    return;
  }
  // Insertion sort: the order changes little from step to step.
  for (std::size_t i = 1; i < order_.size(); ++i) {
    const int pup = order_[i];
    std::size_t j = i;
    for (; j > 0 && before(pup, order_[j - 1]); --j) order_[j] = order_[j - 1];
    order_[j] = pup;
  }
}

template <class Real>
void BroadPhase<Real>::sort_pairs(int pups) {
  // Counting sort by the first pup. Then each pup's few pairs are sorted by the second.
  bucket_.assign(pups + 1, 0);
  for (const NearPair& pair : unsorted_) ++bucket_[pair.first + 1];
  std::partial_sum(bucket_.begin(), bucket_.end(), bucket_.begin());
  pairs_.resize(unsorted_.size());
  for (const NearPair& pair : unsorted_) pairs_[bucket_[pair.first]++] = pair;
  const auto by_second = [](const NearPair& a, const NearPair& b) { return a.second < b.second; };
  int begin = 0;  // bucket_[pup] is now the end of the pairs of `pup`
  for (int pup = 0; pup < pups; begin = bucket_[pup++]) {
    if (bucket_[pup] - begin > 1) {
      std::sort(pairs_.begin() + begin, pairs_.begin() + bucket_[pup], by_second);
    }
  }
}

template <class Real>
const std::vector<NearPair>& BroadPhase<Real>::near_pairs(const std::vector<Bounds<Real>>& boxes,
                                                          Real margin) {
  assert(are_boxes(boxes) && margin >= 0);
  sort_along_axis(boxes);
  const int next = (axis_ + 1) % 3, last = (axis_ + 2) % 3;
  unsorted_.clear();
  // A pup has few neighbours: with this room, later steps of the same litter allocate nothing.
  unsorted_.reserve(std::min(boxes.size() * boxes.size(), kUsualPairs * boxes.size()));
  pairs_.reserve(unsorted_.capacity());
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const Bounds<Real>& a = boxes[order_[i]];
    for (std::size_t j = i + 1; j < order_.size(); ++j) {
      const Bounds<Real>& b = boxes[order_[j]];
      if (b.low[axis_] > a.high[axis_] + margin) break;
      if (!near_along(a, b, next, margin) || !near_along(a, b, last, margin)) continue;
      unsorted_.push_back({std::min(order_[i], order_[j]), std::max(order_[i], order_[j])});
    }
  }
  sort_pairs(static_cast<int>(boxes.size()));
  assert(are_sorted_pairs(pairs_, static_cast<int>(boxes.size())));
  return pairs_;
}

template class BroadPhase<float>;
template class BroadPhase<double>;

}  // namespace pupflow
