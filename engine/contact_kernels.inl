// The loops of the contact stage: which points are near another pup, and which of them touch.
// kernels.inl includes this, once per instruction set.
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
    compress_index(i, bits, ids + count);
    count += std::popcount(bits);
  }
  out.count = count;
  P::broadcast(Real(1e18)).store(out.x + count);  // far from all points; its square is finite
  P::zero().store(out.y + count);
  P::zero().store(out.z + count);
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
  assert(a.count > 0 && b.count > 0 && reach >= 0);
  assert(a.x != b.x && contacts_a.nearest != contacts_b.nearest);
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
  for (Real* const row : {contacts.displacement[0], contacts.displacement[1],
                          contacts.displacement[2], contacts.velocity[0], contacts.velocity[1],
                          contacts.velocity[2], contacts.uppers}) {
    fill(Real(0), count, row);
  }
  fill(std::numeric_limits<Real>::infinity(), count, contacts.nearest);
}

template <class Real>
bool touch_sums(const Candidates<Real>& a, const Candidates<Real>& b, Real reach,
                const CandidateContacts<Real>& contacts_a,
                const CandidateContacts<Real>& contacts_b) {
  assert(a.count > 0 && b.count > 0 && reach >= 0);
  assert(a.x != b.x && contacts_a.nearest != contacts_b.nearest);
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
    P displacement[3] = {zero, zero, zero}, velocity[3] = {zero, zero, zero}, uppers = zero,
      nearest = infinity;
    bool hit = false;
    for (int j = 0; j < count_b; j += kLanes<Real>) {
      const P e[3] = {x - P::load(bx + j), y - P::load(by + j), z - P::load(bz + j)};
      const P d_squared = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
      if (less_bits(d_squared, limit) == 0) continue;
      hit = true;
      // In a contact either a or b is the upper one. The terms of the lower one are zero.
      const P gap = select_less(d_squared, limit, range - sqrt(d_squared), zero);
      const P touches = select_less(d_squared, limit, one, zero);
      const P gap_b = select_less(e[2], zero, gap, zero),
              upper_b = select_less(e[2], zero, touches, zero);
      const P gap_a = gap - gap_b, upper_a = touches - upper_b;
      const P near = select_less(d_squared, limit, d_squared, infinity);
      PUPFLOW_UNROLL for (int axis = 0; axis < 3; ++axis) {
        displacement[axis] += e[axis] * gap_a;
        velocity[axis] += e[axis] * upper_a;
        add(to_b.displacement[axis] + j, zero - e[axis] * gap_b);
        add(to_b.velocity[axis] + j, e[axis] * upper_b);
      }
      uppers += upper_a;
      add(to_b.uppers + j, upper_b);
      nearest = min(near, nearest);
      min(near, P::load(to_b.nearest + j)).store(to_b.nearest + j);
    }
    if (!hit) continue;
    any = true;
    PUPFLOW_UNROLL for (int axis = 0; axis < 3; ++axis) {
      contacts_a.displacement[axis][i] = displacement[axis].sum();
      contacts_a.velocity[axis][i] = -velocity[axis].sum();
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

}  // namespace
}  // namespace pupflow
