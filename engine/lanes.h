// Packs: point arrays are padded to whole packs of 64 bytes, whatever the instruction set. Kernels
// sum in the lanes of packs and then add the lanes in one fixed order, so SSE2, AVX2, AVX-512 and
// NEON give the same bits.
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

/// Numbers per array, in whole packs, for `points` points. The kernels also read packs that begin
/// at the middle, since the second half of a cloud mirrors the first. They fit, too.
template <class Real>
constexpr int stride_for(int points) {
  const int half = points / 2, mirrored = half + padded<Real>(half);
  return padded<Real>(points > mirrored ? points : mirrored);
}

}  // namespace pupflow
