// Bodies of the kernels. Each kernels_*.cpp includes this once, compiled for its instruction set,
// after defining PUPFLOW_KERNELS as the name of its table.
#include <cassert>

#include "engine/contact_kernels.inl"
#include "engine/kernels.h"
#include "engine/modes.h"
#include "engine/pack_loops.h"
#include "engine/point_set.h"
#include "engine/rotation_kernels.inl"

namespace pupflow {
namespace {

template <class Real>
bool bounds(const Real* const xyz[3], int points, Real low[3], Real high[3], Real centre[3],
            Real* radius) {
  assert(points > 0);
  using P = Pack<Real>;
  P stays_zero = P::zero();  // x - x is NaN for infinite and NaN
  for (int axis = 0; axis < 3; ++axis) {
    P least = P::load(xyz[axis]), greatest = least;
    for_whole_packs<Real>(points, [&](int i) PUPFLOW_INLINE {
      const P value = P::load(xyz[axis] + i);
      least = min(value, least);
      greatest = max(value, greatest);
      stays_zero += value - value;
    });
    low[axis] = least.least();
    high[axis] = greatest.greatest();
    centre[axis] = low[axis] / 2 + high[axis] / 2;
  }
  P furthest = P::zero();
  const P cx = P::broadcast(centre[0]), cy = P::broadcast(centre[1]), cz = P::broadcast(centre[2]);
  for_whole_packs<Real>(points, [&](int i) PUPFLOW_INLINE {
    const P dx = P::load(xyz[0] + i) - cx, dy = P::load(xyz[1] + i) - cy,
            dz = P::load(xyz[2] + i) - cz;
    furthest = max(dx * dx + dy * dy + dz * dz, furthest);
  });
  *radius = root(furthest.greatest());
  return stays_zero.sum() == 0;
}

template <class Real>
void floor(Real r, int stride, Real* z, Real* vz) {
  assert(stride % kLanes<Real> == 0 && z != vz);
  using P = Pack<Real>;
  const P height = P::broadcast(r), zero = P::zero();
  for (int i = 0; i < stride; i += kLanes<Real>) {
    const P here = P::load(z + i);
    if (less_bits(here, height) == 0) continue;
    const P speed = P::load(vz + i);
    select_less(here, height, max(speed, zero - speed), speed).store(vz + i);
    select_less(here, height, height, here).store(z + i);
  }
}

template <class Real>
bool wall(const Real* x, const Real* y, int points, Real r, Real arena_squared,
          std::uint64_t* words) {
  using P = Pack<Real>;
  const P radius = P::broadcast(r), limit = P::broadcast(arena_squared);
  for (int w = 0; w < words_for(points); ++w) words[w] = 0;
  std::uint32_t any = 0;
  for (int i = 0; i < points; i += kLanes<Real>) {
    const P px = P::load(x + i), py = P::load(y + i);
    const P dx = max(px, P::zero() - px) + radius, dy = max(py, P::zero() - py) + radius;
    const std::uint32_t bits = less_bits(limit, dx * dx + dy * dy) & point_lanes<Real>(i, points);
    set_bits(words, i, bits);
    any |= bits;
  }
  return any != 0;
}

template <class Real>
void predict(Real h, Real gain, int points, Real* x, Real* v) {
  assert(points > 0 && x != v);
  using P = Pack<Real>;
  const P step = P::broadcast(h), more = P::broadcast(gain);
  for_packs<Real>(points, [&](int i, auto whole) PUPFLOW_INLINE {
    const P here = P::load(x + i), speed = P::load(v + i);
    const P faster = speed + more, moved = here + step * faster;
    (whole ? faster : first_lanes(points - i, faster, speed)).store(v + i);
    (whole ? moved : first_lanes(points - i, moved, here)).store(x + i);
  });
}

/// Sums of the `Count` modes `rows` times one coordinate x. Point half + i mirrors point i
/// (cloud.h), so one pass over the first half reads both. Even modes have the same value at
/// mirrored points and take the sum of both; odd modes have opposite values and take the
/// difference. Several modes at a time share the loads. Their number changes no bit of any sum.
template <int Count, bool Odd, class Real>
void fit_some(const Real* const* rows, int half, const Real* x, Real* sums) {
  using P = Pack<Real>;
  const P zero = P::zero(), origin = P::broadcast(x[0]);
  P sum[Count];
  for (P& mode : sum) mode = zero;
  for_packs<Real>(half, [&](int i, auto whole) PUPFLOW_INLINE {
    const P first = P::load(x + i), second = P::load(x + half + i);
    P value = Odd ? first - second : (first - origin) + (second - origin);
    if (!whole) value = first_lanes(half - i, value, zero);
    PUPFLOW_UNROLL for (int m = 0; m < Count; ++m) sum[m] += P::load(rows[m] + i) * value;
  });
  for (int m = 0; m < Count; ++m) sums[m] = sum[m].sum();
}

/// All `count` modes of one parity, in threes.
template <bool Odd, class Real>
void fit_parity(const Real* const* rows, int count, int half, const Real* x, Real* sums) {
  int m = 0;
  for (; kNativeBytes >= 32 && m + 6 <= count; m += 6) {  // with room for their sums in registers
    fit_some<6, Odd>(rows + m, half, x, sums + m);
  }
  for (; m + 3 <= count; m += 3) fit_some<3, Odd>(rows + m, half, x, sums + m);
  for (; m < count; ++m) fit_some<1, Odd>(rows + m, half, x, sums + m);
}

template <class Real>
void fit(const Real* modes, int count, int points, int stride, const Real* const xyz[3],
         Real sums[][3]) {
  assert(count == mode_count(false) || count == mode_count(true));
  assert(points > 0 && points % 2 == 0 && stride >= stride_for<Real>(points));
  const int half = points / 2;
  const Real* odd[kLinearModes];
  for (int m = 0; m < kLinearModes; ++m) odd[m] = modes + (1 + m) * stride;
  const Real* even[1 + kQuadraticModes] = {modes};  // the mean, then the quadratic modes
  const int quadratic = count - 1 - kLinearModes;
  for (int m = 0; m < quadratic; ++m) even[1 + m] = modes + (1 + kLinearModes + m) * stride;
  for (int axis = 0; axis < 3; ++axis) {
    Real of_odd[kLinearModes], of_even[1 + kQuadraticModes];
    fit_parity<true>(odd, kLinearModes, half, xyz[axis], of_odd);
    fit_parity<false>(even, 1 + quadratic, half, xyz[axis], of_even);
    sums[kMeanMode][axis] = of_even[0];
    for (int m = 0; m < kLinearModes; ++m) sums[1 + m][axis] = of_odd[m];
    for (int m = 0; m < quadratic; ++m) sums[1 + kLinearModes + m][axis] = of_even[1 + m];
  }
}

/// Calls `visit(target, at, lanes)` for the packs of all points, the first at index `at`. `target`
/// is the sum of goal[m] mode_m there. `lanes(value, other)` has `value` in the lanes that are
/// points.
template <int Count, class Real, class Visit>
PUPFLOW_INLINE inline void for_goals(const Real* modes, int half, int stride, const Real* goal,
                                     Visit visit) {
  using P = Pack<Real>;
  const P centre = P::broadcast(goal[kMeanMode]);
  for_packs<Real>(half, [&](int i, auto whole) PUPFLOW_INLINE {
    P odd = P::broadcast(goal[1]) * P::load(modes + stride + i), even = centre;
    PUPFLOW_UNROLL for (int m = 2; m <= kLinearModes; ++m) {
      odd += P::broadcast(goal[m]) * P::load(modes + m * stride + i);
    }
    PUPFLOW_UNROLL for (int m = 1 + kLinearModes; m < Count; ++m) {
      even += P::broadcast(goal[m]) * P::load(modes + m * stride + i);
    }
    const auto lanes = [&](const P& value, const P& other) PUPFLOW_INLINE {
      return whole ? value : first_lanes(half - i, value, other);
    };
    visit(even + odd, i, lanes);
    visit(even - odd, half + i, lanes);
  });
}

template <int Count, class Real>
void pull_some(const Real* modes, int half, int stride, const Real* goal, Real position_share,
               Real velocity_share, Real* x, Real* v) {
  using P = Pack<Real>;
  const P xs = P::broadcast(position_share), vs = P::broadcast(velocity_share);
  const P origin = P::broadcast(x[0]);
  for_goals<Count>(modes, half, stride, goal,
                   [&](const P& target, int at, auto lanes) PUPFLOW_INLINE {
                     const P here = P::load(x + at), d = target - (here - origin);
                     lanes(here + xs * d, here).store(x + at);
                     const P speed = P::load(v + at);
                     lanes(speed + vs * d, speed).store(v + at);
                   });
}

template <class Real>
void pull(const Real* modes, int count, int points, int stride, const Real* goal,
          Real position_share, Real velocity_share, Real* x, Real* v) {
  assert(count == mode_count(false) || count == mode_count(true));
  assert(points > 0 && points % 2 == 0 && stride >= stride_for<Real>(points) && x != v);
  const auto some =
      count == 1 + kLinearModes ? pull_some<1 + kLinearModes, Real> : pull_some<kModes, Real>;
  some(modes, points / 2, stride, goal, position_share, velocity_share, x, v);
}

template <int Count, class Real>
void pull_damped_some(const Real* modes, int half, int stride, const Real* goal, Real stiffness,
                      Real drag, Real rate, Real* x, Real* v) {
  using P = Pack<Real>;
  const P xs = P::broadcast(stiffness), vs = P::broadcast(drag), per_step = P::broadcast(rate);
  const P origin = P::broadcast(x[0]), frame = P::broadcast(v[0]);
  for_goals<Count>(modes, half, stride, goal,
                   [&](const P& target, int at, auto lanes) PUPFLOW_INLINE {
                     const P here = P::load(x + at), speed = P::load(v + at);
                     const P d = (target - xs * (here - origin)) - vs * (speed - frame);
                     lanes(here + d, here).store(x + at);
                     lanes(speed + per_step * d, speed).store(v + at);
                   });
}

template <class Real>
void pull_damped(const Real* modes, int count, int points, int stride, const Real* goal,
                 Real stiffness, Real drag, Real rate, Real* x, Real* v) {
  assert(count == mode_count(false) || count == mode_count(true));
  assert(points > 0 && points % 2 == 0 && stride >= stride_for<Real>(points) && x != v);
  const auto some = count == 1 + kLinearModes ? pull_damped_some<1 + kLinearModes, Real>
                                              : pull_damped_some<kModes, Real>;
  some(modes, points / 2, stride, goal, stiffness, drag, rate, x, v);
}

template <class Real>
Real dot(const Real* a, const Real* b, int stride) {
  assert(stride % kLanes<Real> == 0);
  using P = Pack<Real>;
  P sum = P::zero();
  for (int i = 0; i < stride; i += kLanes<Real>) sum += P::load(a + i) * P::load(b + i);
  return sum.sum();
}

template <class Real>
void left(const Real* x, const Real* y, int points, Real cx, Real cy, Real cosine, Real sine,
          std::uint64_t* words) {
  assert(points > 0);
  using P = Pack<Real>;
  const P px = P::broadcast(cx), py = P::broadcast(cy), c = P::broadcast(cosine),
          s = P::broadcast(sine);
  for (int w = 0; w < words_for(points); ++w) words[w] = 0;
  for (int i = 0; i < points; i += kLanes<Real>) {
    const P across = c * (P::load(y + i) - py) - s * (P::load(x + i) - px);
    set_bits(words, i, less_bits(P::zero(), across) & point_lanes<Real>(i, points));
  }
}

template <class Real>
constexpr Kernels<Real> kKernels{
    bounds<Real>, floor<Real>,       wall<Real>,          predict<Real>,   fit<Real>,
    pull<Real>,   pull_damped<Real>, rotations,           dot<Real>,       left<Real>,
    gather<Real>, box<Real>,         touch_nearest<Real>, touch_sums<Real>};

}  // namespace

extern const Kernels<float> PUPFLOW_KERNELS(float);
extern const Kernels<double> PUPFLOW_KERNELS(double);
const Kernels<float> PUPFLOW_KERNELS(float) = kKernels<float>;
const Kernels<double> PUPFLOW_KERNELS(double) = kKernels<double>;

}  // namespace pupflow
