#include "engine/contact.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/health.h"
#include "engine/pack.h"

namespace pupflow {
namespace {

template <class Real>
bool inside(const Box<Real>& box, Real margin, Real x, Real y, Real z) {
  return x >= box.low[0] - margin && x <= box.high[0] + margin && y >= box.low[1] - margin &&
         y <= box.high[1] + margin && z >= box.low[2] - margin && z <= box.high[2] + margin;
}

}  // namespace

template <class Real>
void Contacts<Real>::gather(const State<Real>& state, int pup, const Box<Real>& other, Real margin,
                            Candidates& candidates) {
  const std::size_t room = state.stride + kLanes<Real>;
  candidates.x.resize(room);
  candidates.y.resize(room);
  candidates.z.resize(room);
  candidates.point.resize(room);
  const std::size_t row = state.row(pup);
  int count = 0;
  for (int i = 0; i < state.points; ++i) {
    const Real x = state.x[row + i], y = state.y[row + i], z = state.z[row + i];
    candidates.x[count] = x;  // overwritten by the next one unless this one counts
    candidates.y[count] = y;
    candidates.z[count] = z;
    candidates.point[count] = i;
    count += inside(other, margin, x, y, z) ? 1 : 0;
  }
  candidates.count = count;
  for (int i = count; i < padded<Real>(count); ++i) {
    candidates.x[i] = std::numeric_limits<Real>::infinity();  // far from everything
  }
}

template <class Real>
void Contacts<Real>::note(std::size_t point, int owner, Real d_squared) {
  Touch& touch = touch_[point];
  if (touch.owner < 0) list_.push_back(point);
  if (touch.owner < 0 ||
      d_squared < touch.nearest) {  // pairs come in order, so the first wins a tie
    touch.owner = owner;
    touch.nearest = d_squared;
  }
}

template <class Real>
void Contacts<Real>::add_contact(const State<Real>& state, TouchingPair pair, int a, int b,
                                 Real d_squared, Real reach) {
  const std::size_t pa = state.row(pair.first) + first_.point[a];
  const std::size_t pb = state.row(pair.second) + second_.point[b];
  note(pa, pair.second, d_squared);
  note(pb, pair.first, d_squared);
  const bool first_is_upper = first_.z[a] >= second_.z[b];
  const Real sign = first_is_upper ? Real(1) : Real(-1);
  const Real e[3] = {sign * (first_.x[a] - second_.x[b]), sign * (first_.y[a] - second_.y[b]),
                     sign * (first_.z[a] - second_.z[b])};
  Touch& touch = touch_[first_is_upper ? pa : pb];
  const Real gap = reach - std::sqrt(d_squared);
  for (int k = 0; k < 3; ++k) {
    touch.push[k] += e[k] * gap;
    touch.pull[k] -= e[k];
  }
  ++touch.uppers;
}

template <class Real>
bool Contacts<Real>::touch_pair(const State<Real>& state, TouchingPair pair, Real reach) {
  using P = Pack<Real>;
  gather(state, pair.first, state.bounds[pair.second], reach, first_);
  if (first_.count == 0) return false;
  gather(state, pair.second, state.bounds[pair.first], reach, second_);
  const P limit = P::broadcast(reach * reach);
  bool any = false;
  for (int a = 0; a < first_.count; ++a) {
    const P ax = P::broadcast(first_.x[a]), ay = P::broadcast(first_.y[a]),
            az = P::broadcast(first_.z[a]);
    for (int block = 0; block < second_.count; block += kLanes<Real>) {
      const P dx = P::load(&second_.x[block]) - ax;
      const P dy = P::load(&second_.y[block]) - ay;
      const P dz = P::load(&second_.z[block]) - az;
      const P d_squared = dx * dx + dy * dy + dz * dz;
      std::uint32_t hits = less_bits(d_squared, limit);
      if (hits == 0) continue;
      any = true;
      Real lane[kLanes<Real>];
      d_squared.store(lane);
      for (; hits != 0; hits &= hits - 1) {
        const int j = std::countr_zero(hits);
        add_contact(state, pair, a, block + j, lane[j], reach);
      }
    }
  }
  return any;
}

template <class Real>
Status Contacts<Real>::apply(const Params& params, State<Real>& state) {
  const auto suspect = static_cast<Real>(kSuspectRadii * params.pup_radius);
  Status status;
  for (const std::size_t i : list_) {
    const Touch& touch = touch_[i];
    if (touch.uppers == 0) continue;
    const auto share = Real(1) / static_cast<Real>(touch.uppers);
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
