// What must hold between the stages of a step, for `assert`: checked in builds without NDEBUG (the
// presets dev, asan and tsan), absent in others.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "engine/state.h"

namespace pupflow {

/// Whether the box of `pup` encloses its points, and the ball does to rounding. NaN passes: it is
/// for a step's status to report.
template <class Real>
bool is_enclosed(const State<Real>& state, int pup) {
  const Bounds<Real>& bounds = state.bounds[pup];
  const AlignedVector<Real>* const component[3] = {&state.x, &state.y, &state.z};
  constexpr double kRounding = 1 + 64 * static_cast<double>(std::numeric_limits<Real>::epsilon());
  constexpr double kUnderflow = 4 * static_cast<double>(std::numeric_limits<Real>::min());
  const double limit = kRounding * static_cast<double>(bounds.radius);
  for (std::size_t i = state.row(pup); i < state.row(pup) + state.points; ++i) {
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Real at = (*component[axis])[i];
      if (at < bounds.low[axis] || at > bounds.high[axis]) return false;
      const double d = static_cast<double>(at) - static_cast<double>(bounds.centre[axis]);
      squared += d * d;
    }
    if (squared > limit * limit + kUnderflow) return false;
  }
  return true;
}

template <class Real>
bool all_enclosed(const State<Real>& state) {
  for (int pup = 0; pup < state.pups; ++pup) {
    if (!is_enclosed(state, pup)) return false;
  }
  return true;
}

/// Whether `pairs` are sorted, without repetition, first < second and both among `pups` pups.
template <class Pair>
bool are_sorted_pairs(const std::vector<Pair>& pairs, int pups) {
  const auto in_order = [](const Pair& a, const Pair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].first < 0 || pairs[i].first >= pairs[i].second || pairs[i].second >= pups) {
      return false;
    }
    if (i > 0 && !in_order(pairs[i - 1], pairs[i])) return false;
  }
  return true;
}

/// Whether no lower side of a box is above its upper side or NaN.
template <class Real>
bool are_boxes(const std::vector<Bounds<Real>>& boxes) {
  return std::all_of(boxes.begin(), boxes.end(), [](const Bounds<Real>& box) {
    return box.low[0] <= box.high[0] && box.low[1] <= box.high[1] && box.low[2] <= box.high[2];
  });
}

}  // namespace pupflow
