#include "engine/watch.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/invariants.h"

namespace pupflow {
namespace {

constexpr int kLastingSteps = 50;
constexpr int kRise = 3;               // a step in an impossible state counts as three others
constexpr double kEnergyMargin = 1.5;  // of height
constexpr double kManySteps = 1e15;

/// Counts up a step in an impossible state, down one in a possible state. True when the impossible
/// state lasts.
bool lasts(bool impossible, int& count) {
  count = impossible ? std::min(count + kRise, kRise * kLastingSteps) : std::max(count - 1, 0);
  return count == kRise * kLastingSteps;
}

template <class Real>
double middle(const State<Real>& state, int pup, int axis) {
  return static_cast<double>(state.bounds[pup].centre[axis]);
}

/// Half the square of the mean velocity.
template <class Real>
double kinetic_energy(const State<Real>& state, int pup) {
  double energy = 0;
  for (const auto* component : {&state.vx, &state.vy, &state.vz}) {
    double mean = 0;
    for (int i = 0; i < state.points; ++i) {
      mean += static_cast<double>((*component)[state.row(pup) + i]) / state.points;
    }
    energy += mean * mean / 2;
  }
  return energy;
}

/// Whether the boxes of all others are further than `distance` from that of `pup` along some axis.
template <class Real>
bool is_alone(const State<Real>& state, int pup, double distance) {
  const Bounds<Real>& box = state.bounds[pup];
  for (int other = 0; other < state.pups; ++other) {
    if (other == pup) continue;
    bool near = true;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = std::max<double>(box.low[axis], state.bounds[other].low[axis]);
      const double high = std::min<double>(box.high[axis], state.bounds[other].high[axis]);
      near = near && low - high <= distance;
    }
    if (near) return false;
  }
  return true;
}

}  // namespace

template <class Real>
void Watch<Real>::begin(const Params& params, const State<Real>& state) {
  past_.assign(static_cast<std::size_t>(state.pups), {});
  double energy = 0;
  for (int pup = 0; pup < state.pups; ++pup) {
    past_[pup].height = middle(state, pup, 2);
    energy = std::max(energy, params.gravity * past_[pup].height + kinetic_energy(state, pup));
  }
  energy += 2 * params.arena_radius * params.drive + 0.5;
  const double stack = 2 * state.pups * (params.pup_radius + params.point_radius);
  highest_ = kEnergyMargin * std::max(energy / params.gravity, stack);
  const double speed = std::sqrt(2 * params.gravity * params.pup_radius);
  slow_move_ = speed * params.dt;
  const double steps = 2 * speed / params.gravity / params.dt;
  slow_steps_ = params.gravity > 0 ? static_cast<std::int64_t>(std::clamp<double>(
                                         std::ceil(steps), kLastingSteps, kManySteps))
                                   : 0;
}

template <class Real>
void Watch<Real>::look(const Params& params, const State<Real>& state) {
  assert(past_.size() == static_cast<std::size_t>(state.pups));
  assert(all_enclosed(state));
  const double wall = params.arena_radius * params.arena_radius;
  const auto warn = [&](Warning::Kind kind, int pup) { warnings_.add({kind, state.step, pup}); };
  for (int pup = 0; pup < state.pups; ++pup) {
    Past& past = past_[pup];
    const double x = middle(state, pup, 0), y = middle(state, pup, 1), z = middle(state, pup, 2);
    if (lasts(z < 0, past.under)) warn(Warning::Kind::sunk, pup);
    if (lasts(x * x + y * y > wall, past.out)) warn(Warning::Kind::outside, pup);
    if (z > highest_) warn(Warning::Kind::gaining_energy, pup);
    past.slow = std::abs(z - past.height) < slow_move_ ? past.slow + 1 : 0;
    past.height = z;
  }
  if (slow_steps_ > 0 && state.step % slow_steps_ == 0) look_for_hanging(params, state);
}

template <class Real>
void Watch<Real>::look_for_hanging(const Params& params, const State<Real>& state) {
  const double floor = params.point_radius + params.pup_radius;
  const double distance = std::max(params.pup_radius, 4 * params.point_radius);
  for (int pup = 0; pup < state.pups; ++pup) {
    Past& past = past_[pup];
    const bool before = past.held_up;
    past.held_up = past.slow >= slow_steps_ &&
                   static_cast<double>(state.bounds[pup].low[2]) > floor &&
                   is_alone(state, pup, distance);
    if (past.held_up && before) warnings_.add({Warning::Kind::hanging, state.step, pup});
  }
}

template class Watch<float>;
template class Watch<double>;

}  // namespace pupflow
