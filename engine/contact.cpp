#include "engine/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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
  numbers.resize(13 * room);
  // Set anew each time: in a copied simulation they would still point into the original.
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
  for (Real*& row : contacts.push) row = take();
  for (Real*& row : contacts.pull) row = take();
  contacts.uppers = take();
}

template <class Real>
void Contacts<Real>::make_room(const State<Real>& state, int workers, std::size_t pairs) {
  workers_.resize(workers);
  const std::size_t usual = 2 * state.row(state.pups) / workers;  // few points touch two pups
  for (Worker& worker : workers_) {
    worker.first.make_room(state.stride);
    worker.second.make_room(state.stride);
    worker.touches.clear();
    worker.searched = 0;
    worker.touches.reserve(usual);
    worker.total.resize(state.points);
    worker.bits.resize(words_for(state.points));
  }
  found_.reserve(pairs);
  ranges_.reserve(2 * pairs);
  ends_.reserve(state.pups + 1);
}

template <class Real>
bool Contacts<Real>::touch_pair(const State<Real>& state, TouchingPair pair, Worker& worker) const {
  const Bounds<Real>& a = state.bounds[pair.first];
  const Bounds<Real>& b = state.bounds[pair.second];
  if (!balls_meet(a, b, reach_)) return false;
  ++worker.searched;
  // First the points of one pup near the other as a whole, then those of the other near these few.
  const Real margin = search_radius(Real(0), reach_);
  const auto gather = [&](int pup, const Bounds<Real>& ball, const Real low[3], const Real high[3],
                          Side& side) {
    const std::size_t row = state.row(pup);
    const Real* xyz[3] = {state.x.data() + row, state.y.data() + row, state.z.data() + row};
    Region<Real> region{{}, search_radius(ball.radius, reach_), {}, {}};
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
  const auto touch =
      rule_ == ContactRule::nearest ? state.kernels->touch_nearest : state.kernels->touch_sums;
  return touch(worker.first.candidates, worker.second.candidates, reach_, worker.first.contacts,
               worker.second.contacts);
}

/// The contacts of candidate `i` of `side` with those of `partners`.
template <class Real>
auto Contacts<Real>::touch_of(const Side& side, const Side& partners, int i) const -> Touch {
  const CandidateContacts<Real>& contacts = side.contacts;
  Touch touch;
  if (rule_ == ContactRule::nearest) {
    touch.lower = contacts.lower[i];
    if (touch.lower < kInfinity) {
      const auto partner = static_cast<int>(contacts.partner[i]);
      const Candidates<Real>&a = side.candidates, &b = partners.candidates;
      const Real e[3] = {a.x[i] - b.x[partner], a.y[i] - b.y[partner], a.z[i] - b.z[partner]};
      const Real gap = reach_ - std::sqrt(touch.lower);
      for (int axis = 0; axis < 3; ++axis) {
        touch.push[axis] = e[axis] * gap;
        touch.pull[axis] = -e[axis];
      }
      touch.movers = 1;
    }
  } else {
    for (int axis = 0; axis < 3; ++axis) {
      touch.push[axis] = contacts.push[axis][i];
      touch.pull[axis] = contacts.pull[axis][i];
    }
    touch.movers = contacts.uppers[i];
  }
  touch.nearest = contacts.nearest[i];
  touch.point = side.candidates.point[i];
  return touch;
}

template <class Real>
auto Contacts<Real>::record(const Side& side, const Side& partners, int other, int worker,
                            std::vector<Touch>& touches) const -> Range {
  const int begin = static_cast<int>(touches.size());
  for_each_point(side.contacts.touching, words_for(side.candidates.count), [&](int i) {
    touches.push_back(touch_of(side, partners, i));
    touches.back().other = other;
  });
  return {worker, begin, static_cast<int>(touches.size())};
}

template <class Real>
void Contacts<Real>::sort_by_pup(const std::vector<TouchingPair>& pairs, State<Real>& state) {
  if (records_.pairs) state.touching.clear();
  ends_.assign(state.pups + 1, 0);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (found_[i].first.begin == found_[i].first.end) continue;
    if (records_.pairs) state.touching.push_back(pairs[i]);
    ++ends_[pairs[i].first + 1];
    ++ends_[pairs[i].second + 1];
  }
  std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
  ranges_.resize(ends_.back());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (found_[i].first.begin == found_[i].first.end) continue;
    ranges_[ends_[pairs[i].first]++] = found_[i].first;
    ranges_[ends_[pairs[i].second]++] = found_[i].second;
  }
}

template <class Real>
void Contacts<Real>::find(const Params& params, ContactRecords records, State<Real>& state,
                          Team& team) {
  rule_ = params.contact;
  records_ = records;
  reach_ = static_cast<Real>(2 * params.point_radius);
  const std::vector<TouchingPair>& pairs = broad_phase_.find(state.bounds, reach_);
  const int workers = useful_workers(team, state.pups);
  make_room(state, workers, pairs.capacity());
  state.touching.reserve(pairs.capacity());
  found_.assign(pairs.size(), {});
  team.run(workers, [&](int worker) {
    Worker& mine = workers_[worker];
    const PupRange share = share_of(static_cast<int>(pairs.size()), worker, workers);
    for (int i = share.begin; i < share.end; ++i) {
      if (!touch_pair(state, pairs[i], mine)) continue;
      found_[i].first = record(mine.first, mine.second, pairs[i].second, worker, mine.touches);
      found_[i].second = record(mine.second, mine.first, pairs[i].first, worker, mine.touches);
    }
  });
  sort_by_pup(pairs, state);
}

template <class Real>
std::int64_t Contacts<Real>::searched_pairs() const {
  std::int64_t sum = 0;
  for (const Worker& worker : workers_) sum += worker.searched;
  return sum;
}

template <class Real>
void Contacts<Real>::add_up(std::span<const Touch> touches, Worker& mine) const {
  for (const Touch& touch : touches) {
    mine.bits[touch.point / 64] |= std::uint64_t{1} << (touch.point % 64);
    Touch& total = mine.total[touch.point];
    if (records_.owners) {
      // Pairs come in the order of pups, so the first of equal distances is that of the lower pup.
      const bool nearer = touch.nearest < total.nearest;
      total.nearest = nearer ? touch.nearest : total.nearest;
      total.other = nearer ? touch.other : total.other;
    }
    if (rule_ == ContactRule::nearest) {
      if (!(touch.lower < total.lower)) continue;
      std::copy(touch.push, touch.push + 3, total.push);
      std::copy(touch.pull, touch.pull + 3, total.pull);
      total.lower = touch.lower;
      total.movers = 1;
    } else {
      for (int axis = 0; axis < 3; ++axis) {
        total.push[axis] += touch.push[axis];
        total.pull[axis] += touch.pull[axis];
      }
      total.movers += touch.movers;
    }
  }
}

/// Moves point `i` as its contacts say. False when that is suspiciously far.
template <class Real>
bool Contacts<Real>::move_point(const Touch& touch, Real share, Real suspect, std::size_t i,
                                State<Real>& state) const {
  const Real mean = 1 / touch.movers;
  if (rule_ == ContactRule::mean) share *= mean;
  const Real push[3] = {share * touch.push[0], share * touch.push[1], share * touch.push[2]};
  state.x[i] += push[0];
  state.y[i] += push[1];
  state.z[i] += push[2];
  state.vx[i] = touch.pull[0] * mean;
  state.vy[i] = touch.pull[1] * mean;
  state.vz[i] = touch.pull[2] * mean;
  return std::abs(push[0]) + std::abs(push[1]) + std::abs(push[2]) < suspect;
}

template <class Real>
Status Contacts<Real>::apply(const Params& params, double share_of_push, State<Real>& state,
                             int pup, int worker) {
  const auto suspect = static_cast<Real>(kSuspectRadii * params.pup_radius);
  const auto share = static_cast<Real>(share_of_push);
  Worker& mine = workers_[worker];
  for (int i = pup == 0 ? 0 : ends_[pup - 1]; i < ends_[pup]; ++i) {
    const Range& range = ranges_[i];
    const std::vector<Touch>& touches = workers_[range.worker].touches;
    add_up({touches.data() + range.begin, touches.data() + range.end}, mine);
  }
  const std::size_t row = state.row(pup);
  int* touched = state.touched.data() + state.flat(pup);
  if (records_.pairs) std::fill(touched, touched + state.points, -1);
  bool sound = true;
  int touching = 0;
  for_each_point(mine.bits.data(), words_for(state.points), [&](int point) {
    Touch& touch = mine.total[point];
    ++touching;
    if (records_.owners) touched[point] = touch.other;
    if (touch.movers > 0) sound &= move_point(touch, share, suspect, row + point, state);
    touch = Touch{};
  });
  if (records_.exposure) {
    std::copy(mine.bits.begin(), mine.bits.end(), state.touching_points.data() + state.set(pup));
    state.exposed[pup] = static_cast<double>(state.points - touching) / state.points;
  }
  std::fill(mine.bits.begin(), mine.bits.end(), 0);
  return sound ? Status{} : inspect_pup(state, pup, params.pup_radius, Stage::contact);
}

template class Contacts<float>;
template class Contacts<double>;

}  // namespace pupflow
