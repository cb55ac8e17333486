// Bodies of the kernels. Each kernels_*.cpp includes this once, compiled for its instruction set,
// after defining PUPFLOW_KERNELS as the name of its table.
#include <bit>
#include <limits>
#include <type_traits>

#include "engine/kernels.h"
#include "engine/modes.h"
#include "engine/pack.h"
#include "engine/point_set.h"

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

template <class Real>
bool bounds(const Real* const xyz[3], int points, Real low[3], Real high[3], Real centre[3],
            Real* radius) {
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

template <class Real>
void predict(Real h, Real gain, int points, Real* x, Real* v) {
  using P = Pack<Real>;
  const P step = P::broadcast(h), more = P::broadcast(gain);
  for_packs<Real>(points, [&](int i, auto whole) PUPFLOW_INLINE {
    const P here = P::load(x + i), speed = P::load(v + i);
    const P faster = speed + more, moved = here + step * faster;
    (whole ? faster : first_lanes(points - i, faster, speed)).store(v + i);
    (whole ? moved : first_lanes(points - i, moved, here)).store(x + i);
  });
}

/// Sums of modes `rows[0]` ... times position. Points come in pairs: number half + i mirrors number
/// i (cloud.h), so one pass over the first half and, at the same places, the second will do. Even
/// modes have the same value at mirrored points, so they see the sum of both; odd ones have
/// opposite values and see the difference. Several modes at a time share the loads; how many does
/// not change a bit of any sum.
template <int Count, bool Odd, class Real>
void fit_some(const Real* const* rows, int half, const Real* const xyz[3], Real* const* sums) {
  using P = Pack<Real>;
  const P zero = P::zero();
  P sum[Count][3];
  for (auto& mode : sum) mode[0] = mode[1] = mode[2] = zero;
  const P origin[3] = {P::broadcast(xyz[0][0]), P::broadcast(xyz[1][0]), P::broadcast(xyz[2][0])};
  for_packs<Real>(half, [&](int i, auto whole) PUPFLOW_INLINE {
    P value[3];
    PUPFLOW_UNROLL for (int axis = 0; axis < 3; ++axis) {
      const P first = P::load(xyz[axis] + i), second = P::load(xyz[axis] + half + i);
      value[axis] = Odd ? first - second : (first - origin[axis]) + (second - origin[axis]);
      if (!whole) value[axis] = first_lanes(half - i, value[axis], zero);
    }
    PUPFLOW_UNROLL for (int m = 0; m < Count; ++m) {
      const P mode = P::load(rows[m] + i);
      PUPFLOW_UNROLL for (int axis = 0; axis < 3; ++axis) sum[m][axis] += mode * value[axis];
    }
  });
  for (int m = 0; m < Count; ++m) {
    for (int axis = 0; axis < 3; ++axis) sums[m][axis] = sum[m][axis].sum();
  }
}

/// All `count` modes of one parity.
template <bool Odd, class Real>
void fit_parity(const Real* const* rows, int count, int half, const Real* const xyz[3],
                Real* const* sums) {
  constexpr int kTogether = kNativeBytes == 64 ? 3 : kNativeBytes == 32 ? 2 : 1;  // by registers
  int m = 0;
  for (; m + kTogether <= count; m += kTogether) {
    fit_some<kTogether, Odd>(rows + m, half, xyz, sums + m);
  }
  for (; m < count; ++m) fit_some<1, Odd>(rows + m, half, xyz, sums + m);
}

template <class Real>
void fit(const Real* modes, int count, int points, int stride, const Real* const xyz[3],
         Real sums[][3]) {
  const Real* row[kModes];
  for (int m = 0; m < count; ++m) row[m] = modes + m * stride;
  const int half = points / 2;
  const Real* const odd[] = {row[1], row[2], row[3]};
  Real* const odd_sums[] = {sums[1], sums[2], sums[3]};
  fit_parity<true>(odd, kLinearModes, half, xyz, odd_sums);
  const Real* even[1 + kQuadraticModes] = {row[kMeanMode]};
  Real* even_sums[1 + kQuadraticModes] = {sums[kMeanMode]};
  int evens = 1;
  for (int m = 1 + kLinearModes; m < count; ++m, ++evens) {
    even[evens] = row[m];
    even_sums[evens] = sums[m];
  }
  fit_parity<false>(even, evens, half, xyz, even_sums);
}

/// Calls `draw(target, at, lanes)` for the packs of all points, `target` being the sum of goal[m]
/// mode[m] there. `lanes(value, other)` has the lanes of `value` that are points.
template <int Count, class Real, class Draw>
PUPFLOW_INLINE inline void for_goals(const Real* modes, int half, int stride, const Real* goal,
                                     Draw draw) {
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
    draw(even + odd, i, lanes);
    draw(even - odd, half + i, lanes);
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
  const auto some = count == 1 + kLinearModes ? pull_damped_some<1 + kLinearModes, Real>
                                              : pull_damped_some<kModes, Real>;
  some(modes, points / 2, stride, goal, stiffness, drag, rate, x, v);
}

template <class Real>
Real dot(const Real* a, const Real* b, int stride) {
  using P = Pack<Real>;
  P sum = P::zero();
  for (int i = 0; i < stride; i += kLanes<Real>) sum += P::load(a + i) * P::load(b + i);
  return sum.sum();
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

template <class Real>
void left(const Real* x, const Real* y, int points, Real cx, Real cy, Real cosine, Real sine,
          std::uint64_t* words) {
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
void gather(const Real* const xyz[3], int points, const Region<Real>& region,
            Candidates<Real>& out) {
  using P = Pack<Real>;
  P centre[3], low[3], high[3];
  for (int axis = 0; axis < 3; ++axis) {
    centre[axis] = P::broadcast(region.centre[axis]);
    low[axis] = P::broadcast(region.low[axis]);
    high[axis] = P::broadcast(region.high[axis]);
  }
  const P limit = P::broadcast(region.radius * region.radius);
  Real* const to[3] = {out.x, out.y, out.z};
  int* const ids = out.point;
  int count = 0;
  for (int i = 0; i < points; i += kLanes<Real>) {
    const P p[3] = {P::load(xyz[0] + i), P::load(xyz[1] + i), P::load(xyz[2] + i)};
    const P dx = p[0] - centre[0], dy = p[1] - centre[1], dz = p[2] - centre[2];
    std::uint32_t bits =
        less_bits(dx * dx + dy * dy + dz * dz, limit) & point_lanes<Real>(i, points);
    if (bits == 0) continue;
    PUPFLOW_UNROLL for (int axis = 0; axis < 3; ++axis) {
      bits &= less_bits(low[axis], p[axis]) & less_bits(p[axis], high[axis]);
    }
    PUPFLOW_UNROLL for (int axis = 0; axis < 3; ++axis) {
      compress(xyz[axis] + i, bits, to[axis] + count);
    }
    compress_index(i, bits, ids + count);
    count += std::popcount(bits);
  }
  out.count = count;
  P::broadcast(Real(1e18)).store(out.x + count);  // near nobody, and its square is finite
  P::zero().store(out.y + count);
  P::zero().store(out.z + count);
}

template <class Real>
void box(const Candidates<Real>& candidates, Real low[3], Real high[3]) {
  using P = Pack<Real>;
  const Real* const rows[3] = {candidates.x, candidates.y, candidates.z};
  const int count = candidates.count;
  for (int axis = 0; axis < 3; ++axis) {
    if (count < kLanes<Real>) {  // no whole pack without padding
      low[axis] = high[axis] = rows[axis][0];
      for (int i = 1; i < count; ++i) {
        low[axis] = rows[axis][i] < low[axis] ? rows[axis][i] : low[axis];
        high[axis] = rows[axis][i] > high[axis] ? rows[axis][i] : high[axis];
      }
      continue;
    }
    P least = P::load(rows[axis]), greatest = least;
    for_whole_packs<Real>(count, [&](int i) PUPFLOW_INLINE {
      const P value = P::load(rows[axis] + i);
      least = min(value, least);
      greatest = max(value, greatest);
    });
    low[axis] = least.least();
    high[axis] = greatest.greatest();
  }
}

template <class Real>
void fill(Real value, int count, Real* row) {
  const Pack<Real> all = Pack<Real>::broadcast(value);
  for (int i = 0; i < count; i += kLanes<Real>) all.store(row + i);
}

/// Marks the candidates that have a contact.
template <class Real>
void mark_touching(const CandidateContacts<Real>& contacts, int count) {
  using P = Pack<Real>;
  const P infinity = P::broadcast(std::numeric_limits<Real>::infinity());
  for (int w = 0; w < words_for(count); ++w) contacts.touching[w] = 0;
  for (int i = 0; i < count; i += kLanes<Real>) {
    set_bits(contacts.touching, i, less_bits(P::load(contacts.nearest + i), infinity));
  }
}

template <class Real>
bool touch_nearest(const Candidates<Real>& a, const Candidates<Real>& b, Real reach,
                   const CandidateContacts<Real>& contacts_a,
                   const CandidateContacts<Real>& contacts_b) {
  using P = Pack<Real>;
  constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
  const P zero = P::zero(), infinity = P::broadcast(kInfinity), limit = P::broadcast(reach * reach),
          ramp = P::load(kRamp<Real>);
  for (Real* const row : {contacts_a.nearest, contacts_a.lower}) fill(kInfinity, a.count, row);
  for (Real* const row : {contacts_b.nearest, contacts_b.lower}) fill(kInfinity, b.count, row);
  const CandidateContacts<Real> of_b = contacts_b;  // pointers that no store in the loop can change
  const Real *const bx = b.x, *const by = b.y, *const bz = b.z;
  const int count_b = b.count;
  bool any = false;
  for (int i = 0; i < a.count; ++i) {
    const P x = P::broadcast(a.x[i]), y = P::broadcast(a.y[i]), z = P::broadcast(a.z[i]),
            index = P::broadcast(static_cast<Real>(i));
    P nearest = infinity, lower = infinity, partner = zero;
    bool hit = false;
    for (int j = 0; j < count_b; j += kLanes<Real>) {
      const P dx = x - P::load(bx + j), dy = y - P::load(by + j), dz = z - P::load(bz + j);
      const P d_squared = dx * dx + dy * dy + dz * dz;
      if (less_bits(d_squared, limit) == 0) continue;
      hit = true;
      const P near = select_less(d_squared, limit, d_squared, infinity);
      nearest = min(near, nearest);
      min(near, P::load(of_b.nearest + j)).store(of_b.nearest + j);
      // Either a or b is the upper one. A strict comparison keeps the first of equal distances.
      const P below_a = select_less(dz, zero, infinity, near);
      partner = select_less(below_a, lower, P::broadcast(static_cast<Real>(j)) + ramp, partner);
      lower = min(below_a, lower);
      const P below_b = select_less(dz, zero, near, infinity), before = P::load(of_b.lower + j);
      select_less(below_b, before, index, P::load(of_b.partner + j)).store(of_b.partner + j);
      min(below_b, before).store(of_b.lower + j);
    }
    if (!hit) continue;
    any = true;
    contacts_a.nearest[i] = nearest.least();
    const Real least = lower.least();
    contacts_a.lower[i] = least;
    // Of the lanes at the least distance, the lowest index.
    contacts_a.partner[i] = select_less(P::broadcast(least), lower, infinity, partner).least();
  }
  if (any) {
    mark_touching(contacts_a, a.count);
    mark_touching(contacts_b, b.count);
  }
  return any;
}

template <class Real>
PUPFLOW_INLINE inline void add(Real* to, const Pack<Real>& value) {
  (Pack<Real>::load(to) + value).store(to);
}

template <class Real>
void clear_sums(const CandidateContacts<Real>& contacts, int count) {
  for (Real* const row : {contacts.push[0], contacts.push[1], contacts.push[2], contacts.pull[0],
                          contacts.pull[1], contacts.pull[2], contacts.uppers}) {
    fill(Real(0), count, row);
  }
  fill(std::numeric_limits<Real>::infinity(), count, contacts.nearest);
}

template <class Real>
bool touch_sums(const Candidates<Real>& a, const Candidates<Real>& b, Real reach,
                const CandidateContacts<Real>& contacts_a,
                const CandidateContacts<Real>& contacts_b) {
  using P = Pack<Real>;
  const P zero = P::zero(), one = P::broadcast(1), range = P::broadcast(reach);
  const P limit = P::broadcast(reach * reach),
          infinity = P::broadcast(std::numeric_limits<Real>::infinity());
  clear_sums(contacts_a, a.count);
  clear_sums(contacts_b, b.count);
  const CandidateContacts<Real> to_b = contacts_b;  // pointers that no store in the loop can change
  const Real *const bx = b.x, *const by = b.y, *const bz = b.z;
  const int count_b = b.count;
  bool any = false;
  for (int i = 0; i < a.count; ++i) {
    const P x = P::broadcast(a.x[i]), y = P::broadcast(a.y[i]), z = P::broadcast(a.z[i]);
    P push[3] = {zero, zero, zero}, pull[3] = {zero, zero, zero}, uppers = zero, nearest = infinity;
    bool hit = false;
    for (int j = 0; j < count_b; j += kLanes<Real>) {
      const P e[3] = {x - P::load(bx + j), y - P::load(by + j), z - P::load(bz + j)};
      const P d_squared = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
      if (less_bits(d_squared, limit) == 0) continue;
      hit = true;
      // Where they touch, either a or b is the upper one; the other's share is zero.
      const P gap = select_less(d_squared, limit, range - sqrt(d_squared), zero);
      const P touches = select_less(d_squared, limit, one, zero);
      const P gap_b = select_less(e[2], zero, gap, zero),
              upper_b = select_less(e[2], zero, touches, zero);
      const P gap_a = gap - gap_b, upper_a = touches - upper_b;
      const P near = select_less(d_squared, limit, d_squared, infinity);
      PUPFLOW_UNROLL for (int axis = 0; axis < 3; ++axis) {
        push[axis] += e[axis] * gap_a;
        pull[axis] += e[axis] * upper_a;
        add(to_b.push[axis] + j, zero - e[axis] * gap_b);
        add(to_b.pull[axis] + j, e[axis] * upper_b);
      }
      uppers += upper_a;
      add(to_b.uppers + j, upper_b);
      nearest = min(near, nearest);
      min(near, P::load(to_b.nearest + j)).store(to_b.nearest + j);
    }
    if (!hit) continue;
    any = true;
    PUPFLOW_UNROLL for (int axis = 0; axis < 3; ++axis) {
      contacts_a.push[axis][i] = push[axis].sum();
      contacts_a.pull[axis][i] = -pull[axis].sum();
    }
    contacts_a.uppers[i] = uppers.sum();
    contacts_a.nearest[i] = nearest.least();
  }
  if (any) {
    mark_touching(contacts_a, a.count);
    mark_touching(contacts_b, b.count);
  }
  return any;
}

template <class Real>
constexpr Kernels<Real> kTable{
    bounds<Real>, floor<Real>, predict<Real>, fit<Real>, pull<Real>,          pull_damped<Real>,
    dot<Real>,    left<Real>,  gather<Real>,  box<Real>, touch_nearest<Real>, touch_sums<Real>};

}  // namespace

extern const Kernels<float> PUPFLOW_KERNELS(float);
extern const Kernels<double> PUPFLOW_KERNELS(double);
const Kernels<float> PUPFLOW_KERNELS(float) = kTable<float>;
const Kernels<double> PUPFLOW_KERNELS(double) = kTable<double>;

}  // namespace pupflow
