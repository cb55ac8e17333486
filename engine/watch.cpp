#include "engine/watch.h"

#include <algorithm>
#include <cmath>

namespace pupflow {
namespace {

constexpr int kLastingSteps = 50;
constexpr int kRise = 3;               // a step in an odd state counts as much as three others
constexpr double kEnergyMargin = 1.5;  // of height
constexpr double kManySteps = 1e15;

/// Counts a step in an odd state, or one in a good state; true when the odd one lasts.
bool lasts(bool odd, int& count) {
  count = odd ? std::min(count + kRise, kRise * kLastingSteps) : std::max(count - 1, 0);
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

}  // namespace

template <class Real>
void Watch<Real>::begin(const Params& params, const State<Real>& state) {
  past_.assign(static_cast<std::size_t>(state.pups), {});
  carried_.assign(past_.size(), 0);
  double energy = 0;
  for (int pup = 0; pup < state.pups; ++pup) {
    past_[pup].height = middle(state, pup, 2);
    energy = std::max(energy, params.gravity * past_[pup].height + kinetic_energy(state, pup));
  }
  energy += 2 * params.arena_radius * params.drive + 0.5;
  const double stack = 2 * state.pups * (params.pup_radius + params.point_radius);
  highest_ = kEnergyMargin * std::max(energy / params.gravity, stack);
  const double speed = std::sqrt(2 * params.gravity * params.pup_radius);
  slow_ = speed * params.dt;
  const double steps = 2 * speed / params.gravity / params.dt;
  slow_steps_ = params.gravity > 0 ? static_cast<std::int64_t>(std::clamp<double>(
                                         std::ceil(steps), kLastingSteps, kManySteps))
                                   : 0;
  if (slow_steps_ > 0) find_carried(params, state);  // makes room
}

template <class Real>
void Watch<Real>::look(const Params& params, const State<Real>& state) {
  const double wall = params.arena_radius * params.arena_radius;
  const auto warn = [&](Warning::Kind kind, int pup) { warnings_.add({kind, state.step, pup}); };
  for (int pup = 0; pup < state.pups; ++pup) {
    Past& past = past_[pup];
    const double x = middle(state, pup, 0), y = middle(state, pup, 1), z = middle(state, pup, 2);
    if (lasts(z < 0, past.under)) warn(Warning::Kind::sunk, pup);
    if (lasts(x * x + y * y > wall, past.out)) warn(Warning::Kind::outside, pup);
    if (z > highest_) warn(Warning::Kind::gaining_energy, pup);
    past.slow = std::abs(z - past.height) < slow_ ? past.slow + 1 : 0;
    past.height = z;
  }
  if (slow_steps_ > 0 && state.step % slow_steps_ == 0) look_for_hanging(params, state);
}

template <class Real>
bool Watch<Real>::is_airborne(const Params& params, const State<Real>& state, int pup) const {
  return static_cast<double>(state.bounds[pup].low[2]) > params.point_radius + params.pup_radius;
}

template <class Real>
void Watch<Real>::look_for_hanging(const Params& params, const State<Real>& state) {
  const auto odd = [&](int pup) {
    return past_[pup].slow >= slow_steps_ && is_airborne(params, state, pup);
  };
  bool any = false;
  for (int pup = 0; pup < state.pups; ++pup) {
    if (!odd(pup)) past_[pup].held_up = false;
    any = any || odd(pup);
  }
  if (!any || warnings_.has(Warning::Kind::hanging)) return;
  find_carried(params, state);
  for (int pup = 0; pup < state.pups; ++pup) {
    const bool held_up = odd(pup) && !carried_[pup];
    if (held_up && past_[pup].held_up) {
      warnings_.add({Warning::Kind::hanging, state.step, pup});
    }
    past_[pup].held_up = held_up;
  }
}

/// Marks who stands on the floor, or is near one who is marked.
template <class Real>
void Watch<Real>::find_carried(const Params& params, const State<Real>& state) {
  for (int pup = 0; pup < state.pups; ++pup) carried_[pup] = !is_airborne(params, state, pup);
  const double reach = params.pup_radius + 2 * params.point_radius;
  const auto& pairs = near_.find(state.bounds, static_cast<Real>(reach));
  for (bool more = true; more;) {
    more = false;
    for (const TouchingPair& pair : pairs) {
      if (carried_[pair.first] == carried_[pair.second]) continue;
      carried_[pair.first] = carried_[pair.second] = 1;
      more = true;
    }
  }
}

template class Watch<float>;
template class Watch<double>;

}  // namespace pupflow
