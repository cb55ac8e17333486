// The loops of the contact stage: which points are near another pup, and which of them touch.
// kernels.inl includes this, once per instruction set.
#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

#include "engine/kernels.h"
#include "engine/pack_loops.h"
#include "engine/point_set.h"

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

// Touching. The points of b are taken a group at a time, as many as floats fill a register. For
// each group, two looks list the points of a that may touch it: those near a ball round the group,
// then those near one of its points. They compare rounded places, with a margin, and only leave out
// what cannot touch; what is listed is computed exactly. So no result depends on the looks or on
// the width of a register. Nobody can predict which points pass, so the looks have no branches.

constexpr int kGroup = kNativeBytes / static_cast<int>(sizeof(float));
using Rough = Pack<float, kNativeBytes>;  // of the points of a group

/// Groups are computed in blocks that are not wider than a pack.
template <class Real>
using Block = Pack<Real, std::min(kPackBytes, kGroup* static_cast<int>(sizeof(Real)))>;
template <class Real>
constexpr int kBlock = Block<Real>::kCount;

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

template <class Real>
void fill(Real value, int count, Real* row) {
  const Pack<Real> all = Pack<Real>::broadcast(value);
  for (int i = 0; i < count; i += kLanes<Real>) all.store(row + i);
}

/// Finds the nearest touching point and the nearest one below, for the points of a and b. For each
/// point of a there is a tile: what each lane of the blocks of b has found.
template <class Real>
class Nearest {
 public:
  using P = Block<Real>;

  Nearest(const Candidates<Real>& a, const Candidates<Real>& b, Real reach,
          const CandidateContacts<Real>& to_a, const CandidateContacts<Real>& to_b, Real* tiles)
      : a_(a), b_(b), to_a_(to_a), to_b_(to_b), limit_(P::broadcast(reach * reach)) {
    const int room = a.count * kBlock<Real>;
    for (int row = 0; row < 3; ++row) tile_[row] = tiles + row * room;
    fill(reach * reach, room, tile_[0]);
    fill(reach * reach, room, tile_[1]);
  }

  /// Begins with the points j, j + 1, ... of b.
  void begin_block(int j) {
    x_ = P::load(b_.x + j);
    y_ = P::load(b_.y + j);
    z_ = P::load(b_.z + j);
    index_ = P::broadcast(static_cast<Real>(j)) + P::load(kRamp<Real>);
    nearest_ = lower_ = limit_;
    partner_ = P::zero();
  }

  /// The points of the block and point i of a.
  PUPFLOW_INLINE void meet(int i) {
    const P dx = P::broadcast(a_.x[i]) - x_, dy = P::broadcast(a_.y[i]) - y_,
            dz = P::broadcast(a_.z[i]) - z_;
    const P squared = dx * dx + dy * dy + dz * dz, zero = P::zero();
    // Either a or b is the upper one. A strict comparison keeps the first of equal distances.
    const P below_a = select_less(dz, zero, limit_, squared);
    const P below_b = select_less(dz, zero, squared, limit_);
    nearest_ = min(squared, nearest_);
    partner_ = select_less(below_b, lower_, P::broadcast(static_cast<Real>(i)), partner_);
    lower_ = min(below_b, lower_);
    Real *const nearest = tile_[0] + i * kBlock<Real>, *const lower = tile_[1] + i * kBlock<Real>,
                *const partner = tile_[2] + i * kBlock<Real>;
    min(squared, P::load(nearest)).store(nearest);
    const P before = P::load(lower);
    select_less(below_a, before, index_, P::load(partner)).store(partner);
    min(below_a, before).store(lower);
  }

  void end_block(int j) const {
    const P infinity = P::broadcast(std::numeric_limits<Real>::infinity());
    select_less(nearest_, limit_, nearest_, infinity).store(to_b_.nearest + j);
    select_less(lower_, limit_, lower_, infinity).store(to_b_.lower + j);
    partner_.store(to_b_.partner + j);
  }

  /// What the tile of point i of a says.
  void fold(int i) const {
    constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
    const Real limit = limit_.part[0][0];
    const P nearest = P::load(tile_[0] + i * kBlock<Real>),
            lower = P::load(tile_[1] + i * kBlock<Real>),
            partner = P::load(tile_[2] + i * kBlock<Real>);
    const Real least = nearest.least(), least_lower = lower.least();
    to_a_.nearest[i] = least < limit ? least : kInfinity;
    to_a_.lower[i] = least_lower < limit ? least_lower : kInfinity;
    // Of the lanes at the least distance, the lowest index.
    to_a_.partner[i] =
        select_less(P::broadcast(least_lower), lower, P::broadcast(kInfinity), partner).least();
  }

 private:
  const Candidates<Real>&a_, &b_;
  const CandidateContacts<Real>&to_a_, &to_b_;
  Real* tile_[3];
  P limit_, x_, y_, z_, index_, nearest_, lower_, partner_;
};

/// Adds `value` to a row.
template <class P, class Real>
PUPFLOW_INLINE inline void add(Real* to, const P& value) {
  (P::load(to) + value).store(to);
}

/// Finds the nearest touching point, and sums over all touching points below. A point's terms are
/// added in the lanes of packs, whatever the blocks.
template <class Real>
class Sums {
 public:
  using P = Block<Real>;

  Sums(const Candidates<Real>& a, const Candidates<Real>& b, Real reach,
       const CandidateContacts<Real>& to_a, const CandidateContacts<Real>& to_b, Real* tiles)
      : a_(a),
        b_(b),
        to_a_(to_a),
        to_b_(to_b),
        reach_(P::broadcast(reach)),
        limit_(reach_ * reach_),
        infinity_(P::broadcast(std::numeric_limits<Real>::infinity())) {
    const int room = a.count * kLanes<Real>;
    for (int row = 0; row < 8; ++row) tile_[row] = tiles + row * room;
    fill(std::numeric_limits<Real>::infinity(), room, tile_[0]);
    fill(Real(0), 7 * room, tile_[1]);
  }

  void begin_block(int j) {
    p_[0] = P::load(b_.x + j);
    p_[1] = P::load(b_.y + j);
    p_[2] = P::load(b_.z + j);
    lane_ = j % kLanes<Real>;
    nearest_ = infinity_;
    uppers_ = P::zero();
    for (int axis = 0; axis < 3; ++axis) displacement_[axis] = velocity_[axis] = P::zero();
  }

  PUPFLOW_INLINE void meet(int i) {
    const P zero = P::zero();
    const P e[3] = {P::broadcast(a_.x[i]) - p_[0], P::broadcast(a_.y[i]) - p_[1],
                    P::broadcast(a_.z[i]) - p_[2]};
    const P squared = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
    // In a contact either a or b is the upper one. The terms of the lower one are zero.
    const P gap = select_less(squared, limit_, reach_ - sqrt(squared), zero);
    const P touches = select_less(squared, limit_, P::broadcast(1), zero);
    const P gap_b = select_less(e[2], zero, gap, zero),
            upper_b = select_less(e[2], zero, touches, zero);
    const P gap_a = gap - gap_b, upper_a = touches - upper_b;
    const P near = select_less(squared, limit_, squared, infinity_);
    const int at = i * kLanes<Real> + lane_;
    nearest_ = min(near, nearest_);
    min(near, P::load(tile_[0] + at)).store(tile_[0] + at);
    uppers_ += upper_b;
    add(tile_[1] + at, upper_a);
    PUPFLOW_UNROLL for (int axis = 0; axis < 3; ++axis) {
      displacement_[axis] += zero - e[axis] * gap_b;
      velocity_[axis] += e[axis] * upper_b;
      add(tile_[2 + axis] + at, e[axis] * gap_a);
      add(tile_[5 + axis] + at, e[axis] * upper_a);
    }
  }

  void end_block(int j) const {
    nearest_.store(to_b_.nearest + j);
    uppers_.store(to_b_.uppers + j);
    for (int axis = 0; axis < 3; ++axis) {
      displacement_[axis].store(to_b_.displacement[axis] + j);
      velocity_[axis].store(to_b_.velocity[axis] + j);
    }
  }

  void fold(int i) const {
    const auto tile = [&](int row) { return Pack<Real>::load(tile_[row] + i * kLanes<Real>); };
    to_a_.nearest[i] = tile(0).least();
    to_a_.uppers[i] = tile(1).sum();
    for (int axis = 0; axis < 3; ++axis) {
      to_a_.displacement[axis][i] = tile(2 + axis).sum();
      to_a_.velocity[axis][i] = -tile(5 + axis).sum();
    }
  }

 private:
  const Candidates<Real>&a_, &b_;
  const CandidateContacts<Real>&to_a_, &to_b_;
  Real* tile_[8];
  P reach_, limit_, infinity_, p_[3], nearest_, uppers_, displacement_[3], velocity_[3];
  int lane_ = 0;
};

/// Marks the candidates that have a contact.
template <class Real>
void mark_touching(const CandidateContacts<Real>& contacts, int count) {
  using P = Pack<Real>;
  const P infinity = P::broadcast(std::numeric_limits<Real>::infinity());
  for (int w = 0; w < words_for(count); ++w) contacts.touching[w] = 0;
  for (int i = 0; i < count; i += kLanes<Real>) {
    set_bits(contacts.touching, i,
             less_bits(P::load(contacts.nearest + i), infinity) & point_lanes<Real>(i, count));
  }
}

template <class Rule, class Real>
bool touch(const Candidates<Real>& a, const Candidates<Real>& b, Real reach,
           const CandidateContacts<Real>& to_a, const CandidateContacts<Real>& to_b,
           const TouchMemory<Real>& memory) {
  assert(a.count > 0 && b.count > 0 && reach >= 0);
  assert(a.x != b.x && to_a.nearest != to_b.nearest);
  const Real origin[3] = {a.x[0], a.y[0], a.z[0]};
  const float size_a = round_off(a, origin, memory.a), size_b = round_off(b, origin, memory.b);
  const float margin = margin_for(size_a < size_b ? size_b : size_a);
  const auto rough_reach = static_cast<float>(reach);
  const float half_limit = rough_reach * rough_reach / 2 + margin;
  set_side_by_side(memory.a, a.count, half_limit);
  Rule rule(a, b, reach, to_a, to_b, memory.tiles);
  for (int i = 0; i < a.count; ++i) memory.met[i] = 0;
  for (int j = 0; j < b.count; j += kGroup) {
    const RoughGroup group(memory.b, j, b.count);
    int count = group.list_near_ball(memory.a, a.count, rough_reach, margin, memory.list);
    count = group.keep_near_points(memory.a, memory.list, count, memory.kept);
    for (int block = j; block < j + kGroup; block += kBlock<Real>) {
      rule.begin_block(block);
      for (int k = 0; k < count; ++k) rule.meet(memory.kept[k]);
      rule.end_block(block);
    }
    for (int k = 0; k < count; ++k) memory.met[memory.kept[k]] = 1;
  }
  bool any = false;
  for (int i = 0; i < a.count; ++i) {
    to_a.nearest[i] = std::numeric_limits<Real>::infinity();
    if (memory.met[i] == 0) continue;
    rule.fold(i);
    any |= to_a.nearest[i] < std::numeric_limits<Real>::infinity();
  }
  if (any) {
    mark_touching(to_a, a.count);
    mark_touching(to_b, b.count);
  }
  return any;
}

template <class Real>
bool touch_nearest(const Candidates<Real>& a, const Candidates<Real>& b, Real reach,
                   const CandidateContacts<Real>& to_a, const CandidateContacts<Real>& to_b,
                   const TouchMemory<Real>& memory) {
  return touch<Nearest<Real>>(a, b, reach, to_a, to_b, memory);
}

template <class Real>
bool touch_sums(const Candidates<Real>& a, const Candidates<Real>& b, Real reach,
                const CandidateContacts<Real>& to_a, const CandidateContacts<Real>& to_b,
                const TouchMemory<Real>& memory) {
  return touch<Sums<Real>>(a, b, reach, to_a, to_b, memory);
}

}  // namespace
}  // namespace pupflow
