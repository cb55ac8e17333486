// The looks of the contact stage: which points may touch. kernels.inl includes this, once per
// instruction set.
//
// Of two near pups, `gather` copies the points of each that are near the other. The points of the
// second, b, are then taken a group at a time, as many as floats fill a register. For each group,
// two looks list the points of the first, a, that may touch it:
//
//   all of a  ->  those near a ball round the group  ->  those near one of its points
//
// They compare rounded places, with a margin, and only leave out what cannot touch. What is listed
// is computed exactly (contact_kernels.inl), so no result depends on the looks or on the width of a
// register. Nobody can predict which points pass, so the looks have no branches.
#include <bit>
#include <cassert>
#include <limits>

#include "engine/compress.h"
#include "engine/kernels.h"
#include "engine/pack_loops.h"

namespace pupflow {
namespace {

template <class Real>
void gather(const Real* const xyz[3], int points, const Region<Real>& region,
            Candidates<Real>& out) {
  assert(points > 0 && region.radius >= 0);
  assert(out.x != xyz[0] && out.y != xyz[1] && out.z != xyz[2]);
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
    count += compress_index<kLanes<Real>>(i, bits, ids + count);
  }
  out.count = count;
  // Far from all points, with a finite square. As many as a group or a pack, at most 16.
  for (int i = count; i < count + 16; i += kLanes<Real>) {
    P::broadcast(Real(1e18)).store(out.x + i);
    P::zero().store(out.y + i);
    P::zero().store(out.z + i);
  }
}

template <class Real>
void box(const Candidates<Real>& candidates, Real low[3], Real high[3]) {
  using P = Pack<Real>;
  const Real* const rows[3] = {candidates.x, candidates.y, candidates.z};
  const int count = candidates.count;
  assert(count > 0);
  for (int axis = 0; axis < 3; ++axis) {
    if (count < kLanes<Real>) {  // a pack would include padding
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

constexpr int kGroup = kNativeBytes / static_cast<int>(sizeof(float));
using Rough = Pack<float, kNativeBytes>;  // of the points of a group

/// Writes four numbers a point, side by side, for looks from the points of a group.
inline void set_side_by_side(const RoughPoints& points, int count, float half_limit) {
  for (int i = 0; i < count; ++i) {
    float* const to = points.beside[i];
    for (int axis = 0; axis < 3; ++axis) to[axis] = points.xyz[axis][i];
    to[3] = points.half_square[i] - half_limit;
  }
}

/// Rounds candidates: their places relative to `origin`, and half their squared distances from it.
/// Returns the largest square.
template <class Real>
float round_off(const Candidates<Real>& candidates, const Real origin[3], const RoughPoints& out) {
  using P = Pack<Real, kGroup* static_cast<int>(sizeof(Real))>;
  const Real* const from[3] = {candidates.x, candidates.y, candidates.z};
  Rough most = Rough::zero();
  for (int i = 0; i < candidates.count; i += kGroup) {
    Rough squared = Rough::zero();
    PUPFLOW_UNROLL for (int axis = 0; axis < 3; ++axis) {
      const Rough p = rounded(P::load(from[axis] + i) - P::broadcast(origin[axis]));
      p.store(out.xyz[axis] + i);
      squared += p * p;
    }
    (squared * Rough::broadcast(0.5f)).store(out.half_square + i);
    most = max(first_lanes(candidates.count - i, squared, most), most);
  }
  return most.greatest();
}

/// More than the rounding errors of half a squared distance between places whose squared distances
/// from the origin are at most `size`. Infinite where squares could overflow: all points then pass.
inline float margin_for(float size) {
  return size < 1e30f ? 0x1p-16f * size : std::numeric_limits<float>::infinity();
}

/// A group of b's points.
struct RoughGroup {
  Rough xyz[3], minus_half_square;
  Rough centre[3];  // of a ball round it, all lanes equal
  float radius;

  RoughGroup(const RoughPoints& b, int j, int count) {
    Rough squared = Rough::zero();
    PUPFLOW_UNROLL for (int axis = 0; axis < 3; ++axis) {
      const Rough p = Rough::load(b.xyz[axis] + j);
      // Lanes behind the last point repeat the first.
      const Rough inside = first_lanes(count - j, p, Rough::broadcast(b.xyz[axis][j]));
      xyz[axis] = p;
      centre[axis] = Rough::broadcast(inside.least() / 2 + inside.greatest() / 2);
      squared += (inside - centre[axis]) * (inside - centre[axis]);
    }
    minus_half_square = Rough::zero() - Rough::load(b.half_square + j);
    radius = root(squared.greatest());
  }

  /// Lists the points of a within `reach` of the ball. Half the squared distance of points p and c
  /// is p^2 / 2 + c^2 / 2 - p c.
  int list_near_ball(const RoughPoints& a, int count_a, float reach, float margin,
                     int* list) const {
    const Rough square = centre[0] * centre[0] + centre[1] * centre[1] + centre[2] * centre[2];
    const Rough limit =
        Rough::broadcast(0.5f) * (square - Rough::broadcast((radius + reach) * (radius + reach))) -
        Rough::broadcast(margin);
    int listed = 0;
    for (int i = 0; i < count_a; i += kGroup) {
      Rough sum = Rough::zero() - Rough::load(a.half_square + i);
      PUPFLOW_UNROLL for (int axis = 0; axis < 3; ++axis) {
        sum = roughly(centre[axis], Rough::load(a.xyz[axis] + i), sum);
      }
      const std::uint32_t near =
          ~less_bits(sum, limit) & kAllLanes<kGroup> & point_lanes<float>(i, count_a);
      listed += compress_index<kGroup>(i, near, list + listed);
    }
    return listed;
  }

  /// Copies to `kept` the listed points p of a for which
  ///
  ///   p^2 / 2 + q^2 / 2 - p q  <  half_limit
  ///
  /// with a point q of the group. Returns their number.
  int keep_near_points(const RoughPoints& a, const int* list, int listed, int* kept) const {
    int count = 0;
    for (int k = 0; k < listed; ++k) {
      const int i = list[k];
      kept[count] = i;
      const float* const p = a.beside[i];
      Rough sum = minus_half_square;
      PUPFLOW_UNROLL for (int axis = 0; axis < 3; ++axis) {
        sum = roughly(xyz[axis], Rough::broadcast(p[axis]), sum);
      }
      count += less_bits(sum, Rough::broadcast(p[3])) != kAllLanes<kGroup> ? 1 : 0;
    }
    return count;
  }
};

}  // namespace
}  // namespace pupflow
