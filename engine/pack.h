// A fixed-width bundle of numbers: 64 bytes, whatever the instruction set. Kernels add up in the
// lanes of packs and reduce them in one fixed order, so the same bits come out of SSE2, AVX2,
// AVX-512 or NEON.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

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

#if defined(__AVX512F__)
constexpr int kNativeBytes = 64;
#elif defined(__AVX__)
constexpr int kNativeBytes = 32;
#else
constexpr int kNativeBytes = 16;
#endif

/// A native vector register. The wider pack is an array of these, which compilers keep in
/// registers.
template <class Real>
struct NativeVector;
template <>
struct NativeVector<float> {
  typedef float type __attribute__((vector_size(kNativeBytes)));
};
template <>
struct NativeVector<double> {
  typedef double type __attribute__((vector_size(kNativeBytes)));
};

template <class Real>
struct Pack {
  using Native = typename NativeVector<Real>::type;
  static constexpr int kParts = kPackBytes / kNativeBytes;
  static constexpr int kNativeLanes = kNativeBytes / static_cast<int>(sizeof(Real));
  Native part[kParts];

  static Pack load(const Real* from) {  // any alignment
    Pack p;
    std::memcpy(p.part, from, sizeof(p.part));
    return p;
  }
  void store(Real* to) const { std::memcpy(to, part, sizeof(part)); }

  static Pack broadcast(Real value) {
    Pack p;
    for (int i = 0; i < kParts; ++i) p.part[i] = Native{} + value;
    return p;
  }
  static Pack zero() {
    Pack p;
    for (int i = 0; i < kParts; ++i) p.part[i] = Native{};
    return p;
  }

  friend Pack operator+(Pack a, const Pack& b) {
    for (int i = 0; i < kParts; ++i) a.part[i] += b.part[i];
    return a;
  }
  friend Pack operator-(Pack a, const Pack& b) {
    for (int i = 0; i < kParts; ++i) a.part[i] -= b.part[i];
    return a;
  }
  friend Pack operator*(Pack a, const Pack& b) {
    for (int i = 0; i < kParts; ++i) a.part[i] *= b.part[i];
    return a;
  }
  Pack& operator+=(const Pack& b) { return *this = *this + b; }

  friend Pack min(Pack a, const Pack& b) {  // b where a is not less
    for (int i = 0; i < kParts; ++i) a.part[i] = a.part[i] < b.part[i] ? a.part[i] : b.part[i];
    return a;
  }
  friend Pack max(Pack a, const Pack& b) {  // b where a is not greater
    for (int i = 0; i < kParts; ++i) a.part[i] = a.part[i] > b.part[i] ? a.part[i] : b.part[i];
    return a;
  }

  /// Bit i is set where lane i of `a` is less than lane i of `b`.
  friend std::uint32_t less_bits(const Pack& a, const Pack& b) {
    std::uint32_t bits = 0;
    for (int i = 0; i < kParts; ++i) {
      bits |= native_less_bits(a.part[i], b.part[i]) << (i * kNativeLanes);
    }
    return bits;
  }

  /// Sum, least and greatest of the lanes; halves are folded onto each other, one defined order.
  Real sum() const {
    return fold([](Real a, Real b) { return a + b; });
  }
  Real least() const {
    return fold([](Real a, Real b) { return a < b ? a : b; });
  }
  Real greatest() const {
    return fold([](Real a, Real b) { return a > b ? a : b; });
  }

 private:
  template <class Operation>
  Real fold(Operation operation) const {
    Real lane[kLanes<Real>];
    store(lane);
    for (int width = kLanes<Real> / 2; width > 0; width /= 2) {
      for (int i = 0; i < width; ++i) lane[i] = operation(lane[i], lane[i + width]);
    }
    return lane[0];
  }

  static std::uint32_t native_less_bits(Native a, Native b) {
#if defined(__AVX512F__)
    if constexpr (sizeof(Real) == 4) {
      return _mm512_cmp_ps_mask(__m512(a), __m512(b), _CMP_LT_OQ);
    } else {
      return _mm512_cmp_pd_mask(__m512d(a), __m512d(b), _CMP_LT_OQ);
    }
#elif defined(__AVX__)
    if constexpr (sizeof(Real) == 4) {
      return static_cast<std::uint32_t>(_mm256_movemask_ps(__m256(a < b)));
    } else {
      return static_cast<std::uint32_t>(_mm256_movemask_pd(__m256d(a < b)));
    }
#elif defined(__SSE2__)
    if constexpr (sizeof(Real) == 4) {
      return static_cast<std::uint32_t>(_mm_movemask_ps(__m128(a < b)));
    } else {
      return static_cast<std::uint32_t>(_mm_movemask_pd(__m128d(a < b)));
    }
#else
    std::uint32_t bits = 0;
    for (int i = 0; i < kNativeLanes; ++i) bits |= (a[i] < b[i] ? 1u : 0u) << i;
    return bits;
#endif
  }
};

}  // namespace pupflow
