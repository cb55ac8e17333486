// Loops over arrays in packs, sets of lanes, and packs rounded to float. Only the kernels include
// this, as pack.h.
#pragma once

#include <cassert>
#include <cstdint>
#include <type_traits>

#include "engine/pack.h"

namespace pupflow {
namespace {

/// Calls `visit(i)` with the beginning i of each pack of the first `points` points. The last pack
/// overlaps the one before it, so that it contains no padding. Only a cloud smaller than a pack is
/// visited with its padding.
template <class Real, class Visit>
PUPFLOW_INLINE inline void for_whole_packs(int points, Visit visit) {
  const int last = points > kLanes<Real> ? points - kLanes<Real> : 0;
  for (int i = 0; i < last; i += kLanes<Real>) visit(i);
  visit(last);
}

/// The number of each lane.
template <class Real>
alignas(kPackBytes) constexpr Real kRamp[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// `value` in the first `count` lanes, `other` in the rest.
template <class Real, int Bytes>
PUPFLOW_INLINE inline Pack<Real, Bytes> first_lanes(int count, const Pack<Real, Bytes>& value,
                                                    const Pack<Real, Bytes>& other) {
  using P = Pack<Real, Bytes>;
  return select_less(P::load(kRamp<Real>), P::broadcast(static_cast<Real>(count)), value, other);
}

/// Calls `visit(i, whole)` for the packs that contain `count` numbers. `whole` is false in the last
/// one when it contains padding.
template <class Real, class Visit>
PUPFLOW_INLINE inline void for_packs(int count, Visit visit) {
  int i = 0;
  for (; i + kLanes<Real> <= count; i += kLanes<Real>) visit(i, std::true_type());
  if (i < count) visit(i, std::false_type());
}

/// The lanes of the pack at `i` that are among the first `points` points, one bit each.
template <class Real>
PUPFLOW_INLINE inline std::uint32_t point_lanes(int i, int points) {
  const int remaining = points - i;
  return remaining >= kLanes<Real> ? ~0u : (1u << remaining) - 1;
}

/// Sets the bits of `words` from i on by `bits`. They must be clear before. A pack never crosses
/// the end of a word.
PUPFLOW_INLINE inline void set_bits(std::uint64_t* words, int i, std::uint32_t bits) {
  assert((words[i / 64] >> (i % 64)) == 0);
  words[i / 64] |= static_cast<std::uint64_t>(bits) << (i % 64);
}

/// All lanes of a pack of `Count` numbers, one bit each.
template <int Count>
constexpr std::uint32_t kAllLanes = (std::uint32_t{1} << Count) - 1;

/// Two halves of a register, side by side.
template <class Native, class Half>
PUPFLOW_INLINE inline Native joined(Half low, Half high) {
  if constexpr (sizeof(Half) == 32) {
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  } else if constexpr (sizeof(Half) == 16) {
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  } else {
    return __builtin_shufflevector(low, high, 0, 1, 2, 3);
  }
}

/// The same numbers as floats.
template <int Bytes>
PUPFLOW_INLINE inline Pack<float, Bytes> rounded(const Pack<float, Bytes>& numbers) {
  return numbers;
}
template <int Bytes>
PUPFLOW_INLINE inline Pack<float, Bytes / 2> rounded(const Pack<double, Bytes>& numbers) {
  using To = Pack<float, Bytes / 2>;
  typedef float Half __attribute__((vector_size(kNativeBytes / 2)));
  To to;
  PUPFLOW_UNROLL for (int i = 0; i < To::kParts; ++i) {
    to.part[i] =
        joined<typename To::Native>(__builtin_convertvector(numbers.part[2 * i], Half),
                                    __builtin_convertvector(numbers.part[2 * i + 1], Half));
  }
  return to;
}

}  // namespace
}  // namespace pupflow
