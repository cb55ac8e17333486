// Sets of a pup's points, one bit each. The time to visit a set grows with the points in it, not
// with the points of the pup.
#pragma once

#include <bit>
#include <cstdint>

#include "pupflow/parameters.h"

namespace pupflow {

/// Words that hold one bit for each of `points` points.
constexpr int words_for(int points) {
  return (points + 63) / 64;
}

/// Words enough for the largest cloud.
constexpr int kMaxPointWords = words_for(6 * kMaxFacePoints * kMaxFacePoints);

/// Multiplied by this, any finite terms can be summed over the points of the largest cloud without
/// overflow.
constexpr double kSumUnit = 0x1p-16;

/// Calls `visit(i)` for each set bit i of `words`, in ascending order.
template <class Visit>
void for_each_point(const std::uint64_t* words, int count, Visit visit) {
  for (int w = 0; w < count; ++w) {
    for (std::uint64_t word = words[w]; word != 0; word &= word - 1) {
      visit(64 * w + std::countr_zero(word));
    }
  }
}

}  // namespace pupflow
