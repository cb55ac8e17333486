#include "engine/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/health.h"
#include "engine/lanes.h"
#include "engine/point_set.h"

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
  point.resize(room + kPackBytes / sizeof(int));
  touching.resize(words_for(static_cast<int>(room)));
  numbers.resize(11 * room);
  // Set anew each time: in a copied simulation they would still point into the original.
  Real* next = numbers.data();
  const auto take = [&] {
    next += room;
    return next - room;
  };
  candidates = {take(), take(), take(), point.data(), 0};
  sums = {{take(), take(), take()}, {take(), take(), take()}, take(), take(), touching.data()};
}

template <class Real>
void Contacts<Real>::make_room(const State<Real>& state, int workers) {
  workers_.resize(workers);
  for (Worker& worker : workers_) {
    worker.first.make_room(state.stride);
    worker.second.make_room(state.stride);
  }
  touch_.resize(state.row(state.pups));
  bits_.resize(static_cast<std::size_t>(state.pups) * words_for(state.points));
}

template <class Real>
bool Contacts<Real>::touch_pair(const State<Real>& state, TouchingPair pair, Real reach,
                                Worker& worker) const {
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
    state.kernels->gather(xyz, state.points, region, side.candidates);
    return side.candidates.count > 0;
  };
  if (!gather(pair.first, b, b.low, b.high, worker.first)) return false;
  Real low[3], high[3];
  state.kernels->box(worker.first.candidates, low, high);
  if (!gather(pair.second, a, low, high, worker.second)) return false;
  return state.kernels->touch(worker.first.candidates, worker.second.candidates, reach,
                              worker.first.sums, worker.second.sums);
}

template <class Real>
void Contacts<Real>::merge(const Side& side, int pup, int other, bool afferents,
                           State<Real>& state) {
  std::uint64_t* bits = bits_.data() + static_cast<std::size_t>(pup) * words_for(state.points);
  Touch* touches = touch_.data() + state.row(pup);
  int* touched = afferents ? state.touched.data() + state.flat(pup) : nullptr;
  const ContactSums<Real>& sums = side.sums;
  for_each_point(sums.touching, words_for(side.candidates.count), [&](int i) {
    const int point = side.candidates.point[i];
    bits[point / 64] |= std::uint64_t{1} << (point % 64);
    Touch& touch = touches[point];
    const bool nearer = sums.nearest[i] < touch.nearest;  // pairs come in order: the first wins
    touch.nearest = nearer ? sums.nearest[i] : touch.nearest;
    if (touched != nullptr) touched[point] = nearer ? other : touched[point];
    for (int axis = 0; axis < 3; ++axis) {
      touch.push[axis] += sums.push[axis][i];
      touch.pull[axis] += sums.pull[axis][i];
    }
    touch.uppers += sums.uppers[i];
  });
}

template <class Real>
void Contacts<Real>::find(const Params& params, bool afferents, State<Real>& state, Team& team) {
  const auto reach = static_cast<Real>(2 * params.point_radius);
  const std::vector<TouchingPair>& pairs = broad_phase_.find(state.bounds, reach);
  const int workers = useful_workers(team, state.pups);
  make_room(state, workers);
  touches_.reserve(pairs.capacity());
  touches_.assign(pairs.size(), 0);
  state.touching.reserve(pairs.capacity());
  // Neighbours mostly belong to the same worker; a pair between two workers is searched by both,
  // each for its own pup.
  owner_.resize(state.pups);
  for (int worker = 0; worker < workers; ++worker) {
    const PupRange share = share_of(state.pups, worker, workers);
    for (int i = share.begin; i < share.end; ++i) owner_[broad_phase_.order()[i]] = worker;
  }
  if (afferents) std::fill(state.touched.begin(), state.touched.end(), -1);
  team.run(workers, [&](int worker) {
    Worker& mine = workers_[worker];
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const TouchingPair pair = pairs[i];
      const bool first = owner_[pair.first] == worker, second = owner_[pair.second] == worker;
      if ((!first && !second) || !touch_pair(state, pair, reach, mine)) continue;
      if (first) {
        touches_[i] = 1;
        merge(mine.first, pair.first, pair.second, afferents, state);
      }
      if (second) merge(mine.second, pair.second, pair.first, afferents, state);
    }
  });
  state.touching.clear();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (touches_[i] != 0) state.touching.push_back(pairs[i]);
  }
}

template <class Real>
Status Contacts<Real>::apply(const Params& params, double share_of_push, bool afferents,
                             State<Real>& state, int pup) {
  const auto push_share = static_cast<Real>(share_of_push);
  const auto suspect = static_cast<Real>(kSuspectRadii * params.pup_radius);
  const int words = words_for(state.points);
  std::uint64_t* bits = bits_.data() + static_cast<std::size_t>(pup) * words;
  bool sound = true;
  int touching = 0;
  for_each_point(bits, words, [&](int point) {
    const std::size_t i = state.row(pup) + point;
    Touch& touch = touch_[i];
    ++touching;
    if (touch.uppers > 0) {
      const Real share = 1 / touch.uppers;
      for (Real& push : touch.push) push *= push_share;
      state.x[i] += touch.push[0];
      state.y[i] += touch.push[1];
      state.z[i] += touch.push[2];
      state.vx[i] = touch.pull[0] * share;
      state.vy[i] = touch.pull[1] * share;
      state.vz[i] = touch.pull[2] * share;
      const Real moved =
          std::abs(touch.push[0]) + std::abs(touch.push[1]) + std::abs(touch.push[2]);
      sound = sound && moved < suspect;
    }
    touch = Touch{};
  });
  std::fill(bits, bits + words, 0);
  if (afferents) state.exposed[pup] = static_cast<double>(state.points - touching) / state.points;
  return sound ? Status{} : inspect_pup(state, pup, params.pup_radius, Stage::contact);
}

template class Contacts<float>;
template class Contacts<double>;

}  // namespace pupflow
