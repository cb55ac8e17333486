// Bodies of the tight kernels. Each tight_*.cpp includes this once, compiled for its instruction
// set, after defining PUPFLOW_TIGHT as the name of its table.
#include "bench/tight.h"

namespace pupflow::bench {
namespace {

constexpr int kAlign = 64;
constexpr int kModes = 9;
#if defined(__AVX512F__)
constexpr int kGroup = 16;
#elif defined(__AVX2__)
constexpr int kGroup = 8;
#else
constexpr int kGroup = 4;
#endif

template <class Real>
Real* aligned(Real* p) {
  return static_cast<Real*>(__builtin_assume_aligned(p, kAlign));
}
template <class Real>
const Real* aligned(const Real* p) {
  return static_cast<const Real*>(__builtin_assume_aligned(p, kAlign));
}

template <class Real>
void predict(const TightPup<Real>& pup, const Real gain[3], Real h) {
  for (int axis = 0; axis < 3; ++axis) {
    Real* __restrict x = aligned(pup.position[axis]);
    Real* __restrict v = aligned(pup.velocity[axis]);
    const Real more = gain[axis];
    for (int i = 0; i < pup.count; ++i) {
      v[i] += more;
      x[i] += h * v[i];
    }
  }
}

template <class Real>
void match_axis(Real* __restrict x, Real* __restrict v, int count, const Real* modes, Real share,
                Real rate) {
  const Real* __restrict m[kModes];
  for (int k = 0; k < kModes; ++k) m[k] = aligned(modes + k * count);
  Real s0 = 0, s1 = 0, s2 = 0, s3 = 0, s4 = 0, s5 = 0, s6 = 0, s7 = 0, s8 = 0;
  for (int i = 0; i < count; ++i) {
    s0 += m[0][i] * x[i];
    s1 += m[1][i] * x[i];
    s2 += m[2][i] * x[i];
    s3 += m[3][i] * x[i];
    s4 += m[4][i] * x[i];
    s5 += m[5][i] * x[i];
    s6 += m[6][i] * x[i];
    s7 += m[7][i] * x[i];
    s8 += m[8][i] * x[i];
  }
  for (int i = 0; i < count; ++i) {
    const Real d = s0 + s1 * m[1][i] + s2 * m[2][i] + s3 * m[3][i] + s4 * m[4][i] + s5 * m[5][i] +
                   s6 * m[6][i] + s7 * m[7][i] + s8 * m[8][i] - x[i];
    x[i] += share * d;
    v[i] += rate * d;
  }
}

template <class Real>
void match(const TightPup<Real>& pup, const Real* modes, Real share, Real rate) {
  for (int axis = 0; axis < 3; ++axis) {
    match_axis(aligned(pup.position[axis]), aligned(pup.velocity[axis]), pup.count, modes, share,
               rate);
  }
}

template <class Real>
Real bounds(const TightPup<Real>& pup, Real low[3], Real high[3]) {
  for (int axis = 0; axis < 3; ++axis) {
    const Real* __restrict x = aligned(pup.position[axis]);
    Real least = x[0], greatest = x[0];
    for (int i = 0; i < pup.count; ++i) {
      least = x[i] < least ? x[i] : least;
      greatest = x[i] > greatest ? x[i] : greatest;
    }
    low[axis] = least;
    high[axis] = greatest;
  }
  const Real cx = (low[0] + high[0]) / 2, cy = (low[1] + high[1]) / 2, cz = (low[2] + high[2]) / 2;
  const Real* __restrict x = aligned(pup.position[0]);
  const Real* __restrict y = aligned(pup.position[1]);
  const Real* __restrict z = aligned(pup.position[2]);
  Real furthest = 0;
  for (int i = 0; i < pup.count; ++i) {
    const Real dx = x[i] - cx, dy = y[i] - cy, dz = z[i] - cz;
    const Real d = dx * dx + dy * dy + dz * dz;
    furthest = d > furthest ? d : furthest;
  }
  return furthest;
}

template <class Real>
int near_pairs(const Real* const a[3], int count_a, const Real* const b[3], int count_b,
               Real limit) {
  const Real* __restrict x = aligned(b[0]);
  const Real* __restrict y = aligned(b[1]);
  const Real* __restrict z = aligned(b[2]);
  int near = 0;
  for (int i = 0; i < count_a; ++i) {
    const Real ax = a[0][i], ay = a[1][i], az = a[2][i];
    int here = 0;
    for (int j = 0; j < count_b; ++j) {
      const Real dx = x[j] - ax, dy = y[j] - ay, dz = z[j] - az;
      here += dx * dx + dy * dy + dz * dz < limit ? 1 : 0;
    }
    near += here;
  }
  return near;
}

template <class Real>
constexpr TightKernels<Real> kTable{kGroup, predict<Real>, match<Real>, bounds<Real>, near_pairs<Real>};

}  // namespace

extern const TightKernels<float> PUPFLOW_TIGHT(float);
extern const TightKernels<double> PUPFLOW_TIGHT(double);
const TightKernels<float> PUPFLOW_TIGHT(float) = kTable<float>;
const TightKernels<double> PUPFLOW_TIGHT(double) = kTable<double>;

}  // namespace pupflow::bench
