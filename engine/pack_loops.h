// Loops over arrays in packs, and sets of lanes. Like pack.h for the kernels alone.
#pragma once

#include <cstdint>
#include <type_traits>

#include "engine/pack.h"

namespace pupflow {
namespace {

/// Calls `visit(i)` with the beginning of each pack of the first `points` points. The last pack
/// reaches back over the one before it, so that padding stays out; only clouds smaller than a pack
/// bring theirs.
template <class Real, class Visit>
PUPFLOW_INLINE inline void for_whole_packs(int points, Visit visit) {
  const int last = points > kLanes<Real> ? points - kLanes<Real> : 0;
  for (int i = 0; i < last; i += kLanes<Real>) visit(i);
  visit(last);
}

/// The number of each lane.
template <class Real>
alignas(kPackBytes) constexpr Real kRamp[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// The lanes of `value` that are among the first `count`, and `other` in the rest.
template <class Real>
PUPFLOW_INLINE inline Pack<Real> first_lanes(int count, const Pack<Real>& value,
                                             const Pack<Real>& other) {
  return select_less(Pack<Real>::load(kRamp<Real>), Pack<Real>::broadcast(static_cast<Real>(count)),
                     value, other);
}

/// Visits the packs that `count` numbers fill: `visit(i, whole)`. The last may not be `whole`.
template <class Real, class Visit>
PUPFLOW_INLINE inline void for_packs(int count, Visit visit) {
  int i = 0;
  for (; i + kLanes<Real> <= count; i += kLanes<Real>) visit(i, std::true_type());
  if (i < count) visit(i, std::false_type());
}

/// Bits of the lanes from `i` on that are points, of which there are `points`.
template <class Real>
PUPFLOW_INLINE inline std::uint32_t point_lanes(int i, int points) {
  const int left = points - i;
  return left >= kLanes<Real> ? ~0u : (1u << left) - 1;
}

/// Sets bits i ... of `words`, which are clear so far. Packs never straddle a word.
PUPFLOW_INLINE inline void set_bits(std::uint64_t* words, int i, std::uint32_t bits) {
  words[i / 64] |= static_cast<std::uint64_t>(bits) << (i % 64);
}

}  // namespace
}  // namespace pupflow
