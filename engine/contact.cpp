#include "engine/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/health.h"
#include "engine/lanes.h"

namespace pupflow {
namespace {

/// A little more than the sum of radii, so that rounding never hides a pair that touches.
template <class Real>
Real search_radius(Real radius, Real reach) {
  return (radius + reach) * (1 + 32 * std::numeric_limits<Real>::epsilon());
}

/// `value` plus `margin` and a hair more, however far out it is.
template <class Real>
Real widened(Real value, Real margin) {
  const Real hair = 4 * std::numeric_limits<Real>::epsilon() * std::abs(value);
  return value + margin + (margin < 0 ? -hair : hair);
}

template <class Real>
bool balls_meet(const Bounds<Real>& a, const Bounds<Real>& b, Real reach) {
  const Real dx = a.centre[0] - b.centre[0], dy = a.centre[1] - b.centre[1],
             dz = a.centre[2] - b.centre[2];
  const Real limit = search_radius(a.radius + b.radius, reach);
  return dx * dx + dy * dy + dz * dz < limit * limit;
}

}  // namespace

template <class Real>
void Contacts<Real>::Side::make_room(int stride) {
  const std::size_t room = stride + kLanes<Real>;
  point.resize(room);
  numbers.resize(11 * room);
  // Set anew each time: in a copied simulation they would still point into the original.
  Real* next = numbers.data();
  const auto take = [&] {
    next += room;
    return next - room;
  };
  candidates = {take(), take(), take(), point.data(), 0, {}, {}};
  sums = {{take(), take(), take()}, {take(), take(), take()}, take(), take()};
}

template <class Real>
void Contacts<Real>::merge(const Side& side, std::size_t row, int other) {
  for (int i = 0; i < side.candidates.count; ++i) {
    const Real nearest = side.sums.nearest[i];
    if (nearest == std::numeric_limits<Real>::infinity()) continue;
    const std::size_t point = row + side.candidates.point[i];
    Touch& touch = touch_[point];
    if (touch.owner < 0) list_.push_back(point);
    if (touch.owner < 0 ||
        nearest < touch.nearest) {  // pairs come in order, so the first wins a tie
      touch.owner = other;
      touch.nearest = nearest;
    }
    for (int axis = 0; axis < 3; ++axis) {
      touch.push[axis] += side.sums.push[axis][i];
      touch.pull[axis] += side.sums.pull[axis][i];
    }
    touch.uppers += side.sums.uppers[i];
  }
}

template <class Real>
bool Contacts<Real>::touch_pair(const State<Real>& state, TouchingPair pair, Real reach) {
  const Bounds<Real>& a = state.bounds[pair.first];
  const Bounds<Real>& b = state.bounds[pair.second];
  if (!balls_meet(a, b, reach)) return false;
  // First the points of one pup near the other as a whole, then those of the other near these few.
  const Real margin = search_radius(Real(0), reach);
  const auto gather = [&](int pup, const Bounds<Real>& ball, const Real low[3], const Real high[3],
                          Side& side) {
    const std::size_t row = state.row(pup);
    const Real* xyz[3] = {state.x.data() + row, state.y.data() + row, state.z.data() + row};
    Region<Real> region{{}, search_radius(ball.radius, reach), {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
      region.centre[axis] = ball.centre[axis];
      region.low[axis] = widened(low[axis], -margin);
      region.high[axis] = widened(high[axis], margin);
    }
    side.make_room(state.stride);
    state.kernels->gather(xyz, state.points, region, side.candidates);
    return side.candidates.count > 0;
  };
  if (!gather(pair.first, b, b.low, b.high, first_)) return false;
  if (!gather(pair.second, a, first_.candidates.low, first_.candidates.high, second_)) return false;
  if (!state.kernels->touch(first_.candidates, second_.candidates, reach, first_.sums,
                            second_.sums)) {
    return false;
  }
  merge(first_, state.row(pair.first), pair.second);
  merge(second_, state.row(pair.second), pair.first);
  return true;
}

template <class Real>
Status Contacts<Real>::apply(const Params& params, State<Real>& state) {
  const auto suspect = static_cast<Real>(kSuspectRadii * params.pup_radius);
  Status status;
  for (const std::size_t i : list_) {
    const Touch& touch = touch_[i];
    if (touch.uppers == 0) continue;
    const Real share = 1 / touch.uppers;
    state.x[i] += touch.push[0];
    state.y[i] += touch.push[1];
    state.z[i] += touch.push[2];
    state.vx[i] = touch.pull[0] * share;
    state.vy[i] = touch.pull[1] * share;
    state.vz[i] = touch.pull[2] * share;
    const Real moved = std::abs(touch.push[0]) + std::abs(touch.push[1]) + std::abs(touch.push[2]);
    if (!(moved < suspect) && status.ok()) {
      const int pup = static_cast<int>(i / state.stride);
      status = inspect_pup(state, pup, params.pup_radius, Stage::contact);
    }
  }
  return status;
}

template <class Real>
void Contacts<Real>::report(State<Real>& state) const {
  std::fill(state.touched.begin(), state.touched.end(), -1);
  std::fill(state.exposed.begin(), state.exposed.end(),
            0.0);  // counts the touching points at first
  for (const std::size_t i : list_) {
    const auto pup = static_cast<int>(i / state.stride);
    state.touched[state.flat(pup) + i % state.stride] = touch_[i].owner;
    state.exposed[pup] += 1;
  }
  for (double& exposed : state.exposed) exposed = (state.points - exposed) / state.points;
}

template <class Real>
Status Contacts<Real>::resolve(const Params& params, bool afferents, State<Real>& state) {
  const auto reach = static_cast<Real>(2 * params.point_radius);
  touch_.resize(state.row(state.pups), Touch{{}, {}, 0, 0, -1});
  list_.clear();
  state.touching.clear();
  for (const TouchingPair pair : broad_phase_.find(state.bounds, reach)) {
    if (touch_pair(state, pair, reach)) state.touching.push_back(pair);
  }
  const Status status = apply(params, state);
  if (afferents) report(state);
  for (const std::size_t i : list_) touch_[i] = Touch{{}, {}, 0, 0, -1};
  return status;
}

template class Contacts<float>;
template class Contacts<double>;

}  // namespace pupflow
