// A pack of numbers in registers. Only the kernels include this, once per instruction set.
// Everything here has internal linkage, so that the linker never uses code of one instruction set
// for another.
#pragma once

#include <bit>
#include <cstdint>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "engine/lanes.h"

namespace pupflow {
namespace {

// Compilers keep the parts of a pack in registers only where loops over them are unrolled early.
#if defined(__clang__)
#define PUPFLOW_UNROLL _Pragma("unroll")
#else
#define PUPFLOW_UNROLL _Pragma("GCC unroll 16")
#endif

// A call would move packs from registers to memory, so functions of packs are always inlined.
#define PUPFLOW_INLINE __attribute__((always_inline))

#if defined(__AVX512F__)
constexpr int kNativeBytes = 64;
#elif defined(__AVX__)
constexpr int kNativeBytes = 32;
#else
constexpr int kNativeBytes = 16;
#endif

template <class Real>
PUPFLOW_INLINE inline Real root(Real value) {
  if constexpr (sizeof(Real) == 4) {
    return __builtin_sqrtf(value);
  } else {
    return __builtin_sqrt(value);
  }
}

/// A native vector register. A pack is an array of these.
template <class Real>
struct NativeVector;
template <>
struct NativeVector<float> {
  typedef float type __attribute__((vector_size(kNativeBytes)));
  typedef float unaligned __attribute__((vector_size(kNativeBytes), aligned(4), may_alias));
};
template <>
struct NativeVector<double> {
  typedef double type __attribute__((vector_size(kNativeBytes)));
  typedef double unaligned __attribute__((vector_size(kNativeBytes), aligned(8), may_alias));
};

/// Numbers side by side in whole registers: a pack of 64 bytes, or the contents of one register.
template <class Real, int Bytes = kPackBytes>
struct Pack {
  using Native = typename NativeVector<Real>::type;
  using Unaligned = typename NativeVector<Real>::unaligned;
  static constexpr int kParts = Bytes / kNativeBytes;
  static constexpr int kCount = Bytes / static_cast<int>(sizeof(Real));
  static constexpr int kNativeLanes = kNativeBytes / static_cast<int>(sizeof(Real));
  Native part[kParts];

  PUPFLOW_INLINE static Pack load(const Real* from) {  // any alignment
    Pack p;
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) {
      p.part[i] = *reinterpret_cast<const Unaligned*>(from + i * kNativeLanes);
    }
    return p;
  }
  PUPFLOW_INLINE void store(Real* to) const {
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) {
      *reinterpret_cast<Unaligned*>(to + i * kNativeLanes) = part[i];
    }
  }

  PUPFLOW_INLINE static Pack broadcast(Real value) {
    Pack p;
    // The sum with 0 would turn -0 into 0, so the compiler would have to compute it.
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) p.part[i] = value - Native{};
    return p;
  }
  PUPFLOW_INLINE static Pack zero() {
    Pack p;
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) p.part[i] = Native{};
    return p;
  }

  PUPFLOW_INLINE friend Pack operator+(Pack a, const Pack& b) {
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) a.part[i] += b.part[i];
    return a;
  }
  PUPFLOW_INLINE friend Pack operator-(Pack a, const Pack& b) {
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) a.part[i] -= b.part[i];
    return a;
  }
  PUPFLOW_INLINE friend Pack operator*(Pack a, const Pack& b) {
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) a.part[i] *= b.part[i];
    return a;
  }
  PUPFLOW_INLINE friend Pack operator/(Pack a, const Pack& b) {
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) a.part[i] /= b.part[i];
    return a;
  }
  PUPFLOW_INLINE Pack& operator+=(const Pack& b) { return *this = *this + b; }

  PUPFLOW_INLINE friend Pack min(Pack a, const Pack& b) {  // b where a is not less
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) a.part[i] =
        a.part[i] < b.part[i] ? a.part[i] : b.part[i];
    return a;
  }
  PUPFLOW_INLINE friend Pack max(Pack a, const Pack& b) {  // b where a is not greater
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) a.part[i] =
        a.part[i] > b.part[i] ? a.part[i] : b.part[i];
    return a;
  }

  /// `yes` in the lanes where a is less than b, else `no`.
  PUPFLOW_INLINE friend Pack select_less(const Pack& a, const Pack& b, Pack yes, const Pack& no) {
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) {
      yes.part[i] = a.part[i] < b.part[i] ? yes.part[i] : no.part[i];
    }
    return yes;
  }

  /// Bit i is set where lane i of `a` is less than lane i of `b`.
  PUPFLOW_INLINE friend std::uint32_t less_bits(const Pack& a, const Pack& b) {
    std::uint32_t bits = 0;
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) {
      bits |= native_less_bits(a.part[i], b.part[i]) << (i * kNativeLanes);
    }
    return bits;
  }

  /// Sum, least and greatest of the lanes, in one defined order (fold).
  PUPFLOW_INLINE Real sum() const {
    return fold([](auto a, auto b) { return a + b; });
  }
  PUPFLOW_INLINE Real least() const {
    return fold([](auto a, auto b) { return a < b ? a : b; });
  }
  PUPFLOW_INLINE Real greatest() const {
    return fold([](auto a, auto b) { return a > b ? a : b; });
  }

  /// a b + c, rounded once or twice, as the instruction set has it. Only for looks at what is to be
  /// computed exactly: the bits differ between instruction sets.
  PUPFLOW_INLINE friend Pack roughly(const Pack& a, const Pack& b, Pack c) {
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) {
      c.part[i] = native_roughly(a.part[i], b.part[i], c.part[i]);
    }
    return c;
  }

  PUPFLOW_INLINE friend Pack sqrt(Pack a) {
    PUPFLOW_UNROLL for (int i = 0; i < kParts; ++i) a.part[i] = native_sqrt(a.part[i]);
    return a;
  }

 private:
  /// Joins lane i of the lower half with lane i of the upper half, until one lane is left.
  template <class Operation>
  PUPFLOW_INLINE Real fold(Operation operation) const {
    Pack p = *this;
    PUPFLOW_UNROLL for (int half = kParts / 2; half > 0; half /= 2) {
      PUPFLOW_UNROLL for (int i = 0; i < half; ++i) {
        p.part[i] = operation(p.part[i], p.part[i + half]);
      }
    }
    return fold_halves(p.part[0], operation);
  }

  template <class Vector, class Operation>
  PUPFLOW_INLINE static Real fold_halves(Vector v, Operation operation) {
    constexpr int kLeft = sizeof(Vector) / sizeof(Real);
    if constexpr (kLeft == 2) {
      return operation(v[0], v[1]);
    } else {
      typedef Real Half __attribute__((vector_size(sizeof(Vector) / 2)));
      return fold_halves<Half>(operation(lower_half<Half>(v), upper_half<Half>(v)), operation);
    }
  }
  template <class Half, class Vector>
  PUPFLOW_INLINE static Half lower_half(Vector v) {
    if constexpr (sizeof(Half) / sizeof(Real) == 8) {
      return __builtin_shufflevector(v, v, 0, 1, 2, 3, 4, 5, 6, 7);
    } else if constexpr (sizeof(Half) / sizeof(Real) == 4) {
      return __builtin_shufflevector(v, v, 0, 1, 2, 3);
    } else {
      return __builtin_shufflevector(v, v, 0, 1);
    }
  }
  template <class Half, class Vector>
  PUPFLOW_INLINE static Half upper_half(Vector v) {
    if constexpr (sizeof(Half) / sizeof(Real) == 8) {
      return __builtin_shufflevector(v, v, 8, 9, 10, 11, 12, 13, 14, 15);
    } else if constexpr (sizeof(Half) / sizeof(Real) == 4) {
      return __builtin_shufflevector(v, v, 4, 5, 6, 7);
    } else {
      return __builtin_shufflevector(v, v, 2, 3);
    }
  }

  PUPFLOW_INLINE static Native native_sqrt(Native a) {
#if defined(__AVX512F__)
    if constexpr (sizeof(Real) == 4) {
      return Native(_mm512_sqrt_ps(__m512(a)));
    } else {
      return Native(_mm512_sqrt_pd(__m512d(a)));
    }
#elif defined(__AVX__)
    if constexpr (sizeof(Real) == 4) {
      return Native(_mm256_sqrt_ps(__m256(a)));
    } else {
      return Native(_mm256_sqrt_pd(__m256d(a)));
    }
#elif defined(__SSE2__)
    if constexpr (sizeof(Real) == 4) {
      return Native(_mm_sqrt_ps(__m128(a)));
    } else {
      return Native(_mm_sqrt_pd(__m128d(a)));
    }
#else
    for (int i = 0; i < kNativeLanes; ++i) a[i] = root(a[i]);
    return a;
#endif
  }

  PUPFLOW_INLINE static Native native_roughly(Native a, Native b, Native c) {
#if defined(__AVX512F__)
    if constexpr (sizeof(Real) == 4)
      return Native(_mm512_fmadd_ps(__m512(a), __m512(b), __m512(c)));
#elif defined(__FMA__)
    if constexpr (sizeof(Real) == 4)
      return Native(_mm256_fmadd_ps(__m256(a), __m256(b), __m256(c)));
#endif
    return a * b + c;
  }

  PUPFLOW_INLINE static std::uint32_t native_less_bits(Native a, Native b) {
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

}  // namespace
}  // namespace pupflow
