// The loops of the contact stage that compute what touches: the nearest points or sums, exactly, in
// the precision of the litter. kernels.inl includes this, once per instruction set.
//
// Each point of b's group is a lane. The points of a that near_kernels.inl lists for the group meet
// it one by one. What b's points have found is kept in registers; what a point of a has found, in
// a tile in memory with one number per lane, which is folded in the end.
#include <algorithm>
#include <cassert>
#include <limits>

#include "engine/kernels.h"
#include "engine/near_kernels.inl"
#include "engine/pack_loops.h"
#include "engine/point_set.h"

namespace pupflow {
namespace {

/// Groups are computed in blocks that are not wider than a pack.
template <class Real>
using Block = Pack<Real, std::min(kPackBytes, kGroup* static_cast<int>(sizeof(Real)))>;
template <class Real>
constexpr int kBlock = Block<Real>::kCount;

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
