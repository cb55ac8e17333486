// Copies without gaps of the numbers, or of their places, that some bits choose. Only the kernels
// include this, as pack.h. There is no branch that depends on the bits where the instruction set
// has an operation for it or moves numbers within a register.
#pragma once

#include <bit>
#include <cstdint>

#include "engine/pack.h"

namespace pupflow {
namespace {

/// The places of the set bits of each byte, in order.
struct PlacesOfBits {
  std::uint8_t of[256][8];
  constexpr PlacesOfBits() : of() {
    for (int byte = 0; byte < 256; ++byte) {
      int count = 0;
      for (int bit = 0; bit < 8; ++bit) {
        if ((byte >> bit) & 1) of[byte][count++] = static_cast<std::uint8_t>(bit);
      }
    }
  }
};
[[maybe_unused]] alignas(64) constexpr PlacesOfBits kPlaces;

/// Writes the lanes of `from` whose bits are set to `to`, without gaps. A whole pack at `to` may be
/// overwritten.
template <class Real>
PUPFLOW_INLINE inline void compress(const Real* from, std::uint32_t bits, Real* to) {
#if defined(__AVX512F__)
  if constexpr (sizeof(Real) == 4) {
    const auto mask = static_cast<__mmask16>(bits);
    _mm512_storeu_ps(to, _mm512_maskz_compress_ps(mask, _mm512_loadu_ps(from)));
  } else {
    const auto mask = static_cast<__mmask8>(bits);
    _mm512_storeu_pd(to, _mm512_maskz_compress_pd(mask, _mm512_loadu_pd(from)));
  }
#elif defined(__AVX2__)
  // Eight floats at a time, or four doubles as pairs of floats, moved by the places in the table.
  constexpr int kTogether = 32 / static_cast<int>(sizeof(Real));
  PUPFLOW_UNROLL for (int i = 0; i < kLanes<Real>; i += kTogether) {
    std::uint32_t moved = (bits >> i) & ((1u << kTogether) - 1);
    const int count = std::popcount(moved);
    if constexpr (sizeof(Real) == 8) {  // each bit twice
      moved = (moved | (moved << 2)) & 0x33;
      moved = ((moved | (moved << 1)) & 0x55) * 3;
    }
    const __m256i places =
        _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(kPlaces.of[moved])));
    const __m256 numbers = _mm256_loadu_ps(reinterpret_cast<const float*>(from + i));
    _mm256_storeu_ps(reinterpret_cast<float*>(to), _mm256_permutevar8x32_ps(numbers, places));
    to += count;
  }
#else
  for (; bits != 0; bits &= bits - 1) *to++ = from[std::countr_zero(bits)];
#endif
}

/// Writes `first` + i for each set bit i of the `Count` <= 16 lowest of `bits` to `to`, without
/// gaps. 64 bytes at `to` may be overwritten. Returns the number of set bits.
template <int Count>
PUPFLOW_INLINE inline int compress_index(int first, std::uint32_t bits, int* to) {
#if defined(__AVX512F__)
  const __m512i ramp = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  const __m512i index = _mm512_add_epi32(ramp, _mm512_set1_epi32(first));
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), index));
#else
  PUPFLOW_UNROLL for (int half = 0; half < Count; half += 8) {
    const std::uint32_t byte = (bits >> half) & 255;
    for (int i = 0; i < 8; ++i) to[i] = first + half + kPlaces.of[byte][i];
    to += std::popcount(byte);
  }
#endif
  return std::popcount(bits);
}

}  // namespace
}  // namespace pupflow
