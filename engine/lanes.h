// Packs: point arrays are padded to whole bundles of 64 bytes, whatever the instruction set.
// Kernels add up in the lanes of packs and fold them in one fixed order, so the same bits come out
// of SSE2, AVX2, AVX-512 or NEON.
#pragma once

namespace pupflow {

constexpr int kPackBytes = 64;

/// Lanes of a pack: 16 floats or 8 doubles.
template <class Real>
constexpr int kLanes = kPackBytes / static_cast<int>(sizeof(Real));

/// `count` rounded up to whole packs.
template <class Real>
constexpr int padded(int count) {
  return (count + kLanes<Real> - 1) / kLanes<Real> * kLanes<Real>;
}

/// Room for `points` points, in whole packs, also when they are counted from the middle: the second
/// half of a cloud mirrors the first.
template <class Real>
constexpr int stride_for(int points) {
  const int half = points / 2, mirrored = half + padded<Real>(half);
  return padded<Real>(points > mirrored ? points : mirrored);
}

}  // namespace pupflow
