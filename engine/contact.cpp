#include "engine/contact.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "engine/health.h"
#include "engine/invariants.h"
#include "engine/point_set.h"

namespace pupflow {

template <class Real>
void Contacts<Real>::make_room(const State<Real>& state, int workers, std::size_t pairs) {
  scratch_.resize(workers);
  const std::size_t usual = 2 * state.row(state.pups) / workers;  // few points touch two pups
  for (Scratch& scratch : scratch_) {
    scratch.first.make_room(state.stride);
    scratch.second.make_room(state.stride);
    scratch.comparison.make_room(state.stride);
    scratch.used = 0;
    scratch.sums.clear();
    scratch.searched = 0;
    scratch.touches.reserve(usual);
    if (rule_ != ContactRule::nearest) scratch.sums.reserve(usual);
    scratch.contacts.resize(state.points);
    scratch.total.resize(state.points);
    scratch.bits.resize(words_for(state.points));
  }
  pair_touches_.reserve(pairs);
  ranges_.reserve(2 * pairs);
  ends_.reserve(state.pups + 1);
}

template <class Real>
bool Contacts<Real>::touch_pair(const State<Real>& state, NearPair pair, Scratch& mine) const {
  if (!balls_meet(state.bounds[pair.first], state.bounds[pair.second], reach_)) return false;
  ++mine.searched;
  if (!find_near_points(state, pair, reach_, mine.first, mine.second)) return false;
  const auto touch =
      rule_ == ContactRule::nearest ? state.kernels->touch_nearest : state.kernels->touch_sums;
  return touch(mine.first.candidates, mine.second.candidates, reach_, mine.first.contacts,
               mine.second.contacts, mine.comparison.memory());
}

/// Records the contacts of `points` with `partners`, points of the pup `other`.
template <class Real>
auto Contacts<Real>::record(const NearPoints<Real>& points, const NearPoints<Real>& partners,
                            int other, int worker) -> TouchRange {
  Scratch& mine = scratch_[worker];
  const CandidateContacts<Real>& contacts = points.contacts;
  const Candidates<Real>&a = points.candidates, &b = partners.candidates;
  const int begin = mine.used;
  if (static_cast<int>(mine.touches.size()) < begin + a.count) mine.touches.resize(begin + a.count);
  Touch* touch = mine.touches.data() + begin;
  for_each_point(contacts.touching, words_for(a.count), [&](int i) {
    touch->point = a.point[i];
    touch->nearest = contacts.nearest[i];
    if (rule_ == ContactRule::nearest) {
      const bool moves = contacts.lower[i] < kInfinity;
      const int partner = moves ? static_cast<int>(contacts.partner[i]) : 0;
      touch->lower = contacts.lower[i];
      touch->apart[0] = a.x[i] - b.x[partner];
      touch->apart[1] = a.y[i] - b.y[partner];
      touch->apart[2] = a.z[i] - b.z[partner];
    } else {
      Sums& sums = mine.sums.emplace_back();
      sums.movers = contacts.uppers[i];
      for (int axis = 0; axis < 3; ++axis) {
        sums.displacement[axis] = contacts.displacement[axis][i];
        sums.velocity[axis] = contacts.velocity[axis][i];
      }
    }
    ++touch;
  });
  mine.used = static_cast<int>(touch - mine.touches.data());
  return {worker, begin, mine.used, other};
}

template <class Real>
void Contacts<Real>::sort_by_pup(const std::vector<NearPair>& pairs, State<Real>& state) {
  if (records_.pairs) state.touching.clear();
  ends_.assign(state.pups + 1, 0);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pair_touches_[i].first.begin == pair_touches_[i].first.end) continue;
    if (records_.pairs) state.touching.push_back({pairs[i].first, pairs[i].second});
    ++ends_[pairs[i].first + 1];
    ++ends_[pairs[i].second + 1];
  }
  std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
  ranges_.resize(ends_.back());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pair_touches_[i].first.begin == pair_touches_[i].first.end) continue;
    ranges_[ends_[pairs[i].first]++] = pair_touches_[i].first;
    ranges_[ends_[pairs[i].second]++] = pair_touches_[i].second;
  }
}

template <class Real>
void Contacts<Real>::find(const Params& params, ContactRecords records, State<Real>& state,
                          Team& team) {
  assert(all_enclosed(state));
  rule_ = params.contact;
  records_ = records;
  reach_ = static_cast<Real>(2 * params.point_radius);
  const std::vector<NearPair>& pairs = broad_phase_.near_pairs(state.bounds, reach_);
  const int workers = useful_workers(team, state.pups);
  make_room(state, workers, pairs.capacity());
  state.touching.reserve(pairs.capacity());
  pair_touches_.assign(pairs.size(), {});
  team.run(workers, [&](int worker) {
    Scratch& mine = scratch_[worker];
    const Share share = share_of(static_cast<int>(pairs.size()), worker, workers);
    for (int i = share.begin; i < share.end; ++i) {
      if (!touch_pair(state, pairs[i], mine)) continue;
      pair_touches_[i].first = record(mine.first, mine.second, pairs[i].second, worker);
      pair_touches_[i].second = record(mine.second, mine.first, pairs[i].first, worker);
    }
  });
  sort_by_pup(pairs, state);
}

template <class Real>
std::int64_t Contacts<Real>::searched_pairs() const {
  std::int64_t sum = 0;
  for (const Scratch& scratch : scratch_) sum += scratch.searched;
  return sum;
}

/// Adds the contacts with one other pup to those with the pups before it.
template <class Real>
void Contacts<Real>::join(const TouchRange& range, Scratch& mine) const {
  const Scratch& source = scratch_[range.worker];
  std::uint64_t bits = 0;  // of a word: points come in order
  int word = 0;
  for (int i = range.begin; i < range.end; ++i) {
    const Touch& touch = source.touches[i];
    assert(touch.point >= 0 && touch.point < static_cast<int>(mine.contacts.size()));
    if (touch.point / 64 != word) {
      mine.bits[word] |= bits;
      word = touch.point / 64;
      bits = 0;
    }
    bits |= std::uint64_t{1} << (touch.point % 64);
    Contact& contact = mine.contacts[touch.point];
    // Pairs are sorted, so the first of equal distances is that of the lower pup.
    const bool nearer = touch.nearest < contact.nearest, lower = touch.lower < contact.lower;
    contact.nearest = nearer ? touch.nearest : contact.nearest;
    contact.owner = nearer ? range.other : contact.owner;
    contact.lower = lower ? touch.lower : contact.lower;
    contact.mover = lower ? &touch : contact.mover;
  }
  mine.bits[word] |= bits;
  if (rule_ == ContactRule::nearest) return;
  for (int i = range.begin; i < range.end; ++i) {
    const Sums& sums = source.sums[i];
    Sums& total = mine.total[source.touches[i].point];
    for (int axis = 0; axis < 3; ++axis) {
      total.displacement[axis] += sums.displacement[axis];
      total.velocity[axis] += sums.velocity[axis];
    }
    total.movers += sums.movers;
  }
}

/// Moves a point, number `i` of the litter, by its contacts, if any do. False when the displacement
/// is `suspect` or more, or not finite.
template <class Real>
bool Contacts<Real>::move_point(int point, Scratch& mine, Real factor, Real suspect, std::size_t i,
                                State<Real>& state) const {
  Real d[3], v[3];
  if (rule_ == ContactRule::nearest) {
    const Touch* const mover = mine.contacts[point].mover;
    if (mover == nullptr) return true;
    const Real gap = reach_ - std::sqrt(mover->lower);
    for (int axis = 0; axis < 3; ++axis) {
      d[axis] = factor * (mover->apart[axis] * gap);
      v[axis] = -mover->apart[axis];
    }
  } else {
    const Sums total = std::exchange(mine.total[point], {});
    if (total.movers == 0) return true;
    const Real mean = 1 / total.movers;
    if (rule_ == ContactRule::mean) factor *= mean;
    for (int axis = 0; axis < 3; ++axis) {
      d[axis] = factor * total.displacement[axis];
      v[axis] = total.velocity[axis] * mean;
    }
  }
  state.x[i] += d[0];
  state.y[i] += d[1];
  state.z[i] += d[2];
  state.vx[i] = v[0];
  state.vy[i] = v[1];
  state.vz[i] = v[2];
  return std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]) < suspect;
}

template <class Real>
Status Contacts<Real>::apply(const Params& params, double factor, State<Real>& state, int pup,
                             int worker) {
  assert(pup >= 0 && pup < state.pups && ends_.size() == state.pups + std::size_t{1});
  assert(worker >= 0 && worker < static_cast<int>(scratch_.size()));
  const auto suspect = static_cast<Real>(kSuspectRadii * params.pup_radius);
  const auto real_factor = static_cast<Real>(factor);
  Scratch& mine = scratch_[worker];
  for (int i = pup == 0 ? 0 : ends_[pup - 1]; i < ends_[pup]; ++i) join(ranges_[i], mine);
  const std::size_t row = state.row(pup);
  int* touched = state.touched.data() + state.flat(pup);
  if (records_.pairs) std::fill(touched, touched + state.points, -1);
  bool sound = true;
  int touching = 0;
  for (int word = 0; word < words_for(state.points); ++word) {
    touching += std::popcount(mine.bits[word]);
    for (std::uint64_t bits = mine.bits[word]; bits != 0; bits &= bits - 1) {
      const int point = 64 * word + std::countr_zero(bits);
      if (records_.owners) touched[point] = mine.contacts[point].owner;
      sound &= move_point(point, mine, real_factor, suspect, row + point, state);
      mine.contacts[point] = {};
    }
  }
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
