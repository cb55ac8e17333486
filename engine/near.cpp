#include "engine/near.h"

#include <cmath>
#include <limits>

#include "engine/lanes.h"
#include "engine/point_set.h"

namespace pupflow {
namespace {

constexpr int kMargin = 16;  // behind candidates, for whole packs of either precision

/// radius + reach, plus more than the rounding errors of a comparison with it: no contact is lost.
template <class Real>
Real search_radius(Real radius, Real reach) {
  return (radius + reach) * (1 + 32 * std::numeric_limits<Real>::epsilon());
}

/// value + margin, moved further in the direction of `margin` by more than its rounding error.
template <class Real>
Real widened(Real value, Real margin) {
  const Real rounding = 4 * std::numeric_limits<Real>::epsilon() * std::abs(value);
  return value + margin + (margin < 0 ? -rounding : rounding);
}

}  // namespace

template <class Real>
bool balls_meet(const Bounds<Real>& a, const Bounds<Real>& b, Real reach) {
  const Real dx = a.centre[0] - b.centre[0], dy = a.centre[1] - b.centre[1],
             dz = a.centre[2] - b.centre[2];
  const Real limit = search_radius(a.radius + b.radius, reach);
  return dx * dx + dy * dy + dz * dz < limit * limit;
}

template <class Real>
void NearPoints<Real>::make_room(int stride) {
  const std::size_t room = stride + kMargin;
  point.resize(room + kPackBytes / sizeof(int));
  touching.resize(words_for(static_cast<int>(room)));
  numbers.resize(13 * room);
  // Pointers are set each time: in a copied simulation they would still point into the original.
  Real* next = numbers.data();
  const auto take = [&] {
    next += room;
    return next - room;
  };
  candidates = {take(), take(), take(), point.data(), 0};
  contacts.nearest = take();
  contacts.touching = touching.data();
  contacts.lower = take();
  contacts.partner = take();
  for (Real*& row : contacts.displacement) row = take();
  for (Real*& row : contacts.velocity) row = take();
  contacts.uppers = take();
}

template <class Real>
void Comparison<Real>::make_room(int stride) {
  const std::size_t room = stride + kMargin;
  rough.resize(12 * room);
  list.resize(2 * room);
  met.resize(room);
  tiles.resize(8 * kLanes<Real> * room);
}

template <class Real>
TouchMemory<Real> Comparison<Real>::memory() {
  const std::size_t room = met.size();
  float* next = rough.data();
  const auto take = [&] {
    next += room;
    return next - room;
  };
  return {
      {{take(), take(), take()}, take(), reinterpret_cast<float(*)[4]>(rough.data() + 8 * room)},
      {{take(), take(), take()}, take(), nullptr},
      list.data(),
      list.data() + room,
      met.data(),
      tiles.data()};
}

template <class Real>
bool find_near_points(const State<Real>& state, NearPair pair, Real reach, NearPoints<Real>& first,
                      NearPoints<Real>& second) {
  const Bounds<Real>& a = state.bounds[pair.first];
  const Bounds<Real>& b = state.bounds[pair.second];
  // First the points of the first pup that are near the other's bounds, then the points of the
  // second that are near the box round these.
  const Real margin = search_radius(Real(0), reach);
  const auto gather = [&](int pup, const Bounds<Real>& ball, const Real low[3], const Real high[3],
                          NearPoints<Real>& near) {
    const std::size_t row = state.row(pup);
    const Real* xyz[3] = {state.x.data() + row, state.y.data() + row, state.z.data() + row};
    Region<Real> region{{}, search_radius(ball.radius, reach), {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
      region.centre[axis] = ball.centre[axis];
      region.low[axis] = widened(low[axis], -margin);
      region.high[axis] = widened(high[axis], margin);
    }
    state.kernels->gather(xyz, state.points, region, near.candidates);
    return near.candidates.count > 0;
  };
  if (!gather(pair.first, b, b.low, b.high, first)) return false;
  Real low[3], high[3];
  state.kernels->box(first.candidates, low, high);
  return gather(pair.second, a, low, high, second);
}

#define PUPFLOW_INSTANTIATE(Real)                                                             \
  template bool balls_meet<Real>(const Bounds<Real>&, const Bounds<Real>&, Real);             \
  template struct NearPoints<Real>;                                                           \
  template struct Comparison<Real>;                                                           \
  template bool find_near_points<Real>(const State<Real>&, NearPair, Real, NearPoints<Real>&, \
                                       NearPoints<Real>&);
PUPFLOW_INSTANTIATE(float)
PUPFLOW_INSTANTIATE(double)
#undef PUPFLOW_INSTANTIATE

}  // namespace pupflow
