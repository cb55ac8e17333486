#include "engine/state.h"

#include <bit>

#include "engine/pack.h"
#include "engine/rng.h"

namespace pupflow {

template <class Real>
State<Real> make_state(int pups, int points) {
  State<Real> state;
  state.pups = pups;
  state.points = points;
  state.stride = padded<Real>(points);
  for (auto* component : {&state.x, &state.y, &state.z, &state.vx, &state.vy, &state.vz}) {
    component->assign(state.row(pups), Real(0));
  }
  state.bounds.assign(pups, {});
  state.tb.assign(pups, 0);
  state.heading.assign(pups, 0);
  state.exposed.assign(pups, 1);
  state.touched.assign(state.flat(pups), -1);
  return state;
}

template <class Real>
bool update_bounds(State<Real>& state, int pup) {
  using P = Pack<Real>;
  const Real* component[3] = {state.x.data() + state.row(pup), state.y.data() + state.row(pup),
                              state.z.data() + state.row(pup)};
  Box<Real>& box = state.bounds[pup];
  P stays_zero = P::zero();  // x - x is NaN for infinite and NaN
  for (int axis = 0; axis < 3; ++axis) {
    P low = P::load(component[axis]), high = low;
    for (int i = 0; i < state.stride; i += kLanes<Real>) {
      const P value = P::load(component[axis] + i);
      low = min(value, low);
      high = max(value, high);
      stays_zero += value - value;
    }
    box.low[axis] = low.least();
    box.high[axis] = high.greatest();
  }
  return stays_zero.sum() == 0;
}

template <class Real>
std::uint64_t hash_state(const State<Real>& state) {
  std::uint64_t hash = 0;
  const auto add = [&](auto value) {
    if constexpr (sizeof(value) == 4) {
      hash = mix_bits(hash ^ std::bit_cast<std::uint32_t>(value));
    } else {
      hash = mix_bits(hash ^ std::bit_cast<std::uint64_t>(value));
    }
  };
  for (int pup = 0; pup < state.pups; ++pup) {
    for (const auto* component : {&state.x, &state.y, &state.z, &state.vx, &state.vy, &state.vz}) {
      const Real* row = component->data() + state.row(pup);
      for (int i = 0; i < state.points; ++i) add(row[i]);
    }
    add(state.tb[pup]);
    add(state.heading[pup]);
  }
  add(state.step);
  return hash;
}

template struct State<float>;
template struct State<double>;
template State<float> make_state<float>(int, int);
template State<double> make_state<double>(int, int);
template bool update_bounds<float>(State<float>&, int);
template bool update_bounds<double>(State<double>&, int);
template std::uint64_t hash_state<float>(const State<float>&);
template std::uint64_t hash_state<double>(const State<double>&);

}  // namespace pupflow
