// Rotations of several matrices side by side, one in each lane. kernels.inl includes this, once per
// instruction set.
#include <cstdint>

#include "engine/kernels.h"
#include "engine/pack_loops.h"

namespace pupflow {
namespace {

using Lanes = Pack<double>;
static_assert(Lanes::kCount == kRotationLanes);

/// A 3 x 3 matrix per lane, by columns.
struct LaneMatrix {
  Lanes at[9];

  PUPFLOW_INLINE const Lanes& operator()(int i, int j) const { return at[3 * j + i]; }

  PUPFLOW_INLINE static LaneMatrix load(const double a[9][kRotationLanes]) {
    LaneMatrix m;
    for (int k = 0; k < 9; ++k) m.at[k] = Lanes::load(a[k]);
    return m;
  }
  PUPFLOW_INLINE void store(double a[9][kRotationLanes]) const {
    for (int k = 0; k < 9; ++k) at[k].store(a[k]);
  }
};

PUPFLOW_INLINE inline Lanes absolute(const Lanes& a) {
  return max(a, Lanes::zero() - a);
}

/// Matrix of cofactors: det(a) times the inverse transposed.
inline LaneMatrix cofactors(const LaneMatrix& a) {
  LaneMatrix c;
  for (int j = 0; j < 3; ++j) {
    const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    for (int i = 0; i < 3; ++i) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
      c.at[3 * j + i] = a(i1, j1) * a(i2, j2) - a(i1, j2) * a(i2, j1);
    }
  }
  return c;
}

PUPFLOW_INLINE inline Lanes dot_columns(const LaneMatrix& a, const LaneMatrix& b, int j) {
  return a(0, j) * b(0, j) + a(1, j) * b(1, j) + a(2, j) * b(2, j);
}

PUPFLOW_INLINE inline Lanes norm_squared(const LaneMatrix& a) {
  return dot_columns(a, a, 0) + dot_columns(a, a, 1) + dot_columns(a, a, 2);
}

/// Newton's iteration to the orthogonal polar factor of `a`, which has det > 0:
///
///   x <- (s x + x^(-T) / s) / 2
///
/// A lane that has converged keeps its matrix.
inline LaneMatrix polar_by_newton(const LaneMatrix& a) {
  const Lanes one = Lanes::broadcast(1), half = Lanes::broadcast(0.5),
              converged = Lanes::broadcast(1e-30), nearly = Lanes::broadcast(1e-4);
  LaneMatrix x = a;
  Lanes change = one;
  for (int i = 0; i < 20 && less_bits(converged, change) != 0; ++i) {
    const LaneMatrix c = cofactors(x);
    const Lanes inverse_det = one / dot_columns(x, c, 0);
    // Scaling brings singular values that are far from 1 near it. In the last iterations it would
    // only add rounding errors.
    const Lanes scale = select_less(
        nearly, change, sqrt(sqrt(norm_squared(c) / norm_squared(x)) * absolute(inverse_det)), one);
    const Lanes keep = half * scale, turn = half * inverse_det / scale, before = change;
    Lanes sum = Lanes::zero();
    for (int k = 0; k < 9; ++k) {
      const Lanes next = keep * x.at[k] + turn * c.at[k], difference = next - x.at[k];
      sum += difference * difference;
      x.at[k] = select_less(converged, before, next, x.at[k]);
    }
    change = select_less(converged, before, sum, before);
  }
  return x;
}

inline std::uint32_t rotations(double a[9][kRotationLanes]) {
  LaneMatrix m = LaneMatrix::load(a);
  Lanes size = Lanes::zero();
  for (const Lanes& value : m.at) size = max(absolute(value), size);
  for (Lanes& value : m.at) value = value / size;
  const Lanes det = dot_columns(m, cofactors(m), 0), norm = norm_squared(m);
  const std::uint32_t regular = less_bits(Lanes::broadcast(kFlatCloud) * norm * sqrt(norm), det);
  if (regular != 0) polar_by_newton(m).store(a);
  return regular;
}

}  // namespace
}  // namespace pupflow
