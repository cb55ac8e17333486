#include "engine/state.h"

#include <bit>
#include <cassert>

#include "engine/lanes.h"
#include "engine/rng.h"

namespace pupflow {

template <class Real>
State<Real> make_state(int pups, int points, InstructionSet set) {
  assert(pups >= 0 && points > 0 && words_for(points) <= kMaxPointWords);
  State<Real> state;
  state.kernels = &kernels_for<Real>(set);
  state.pups = pups;
  state.points = points;
  state.stride = stride_for<Real>(points);
  for (auto* component : {&state.x, &state.y, &state.z, &state.vx, &state.vy, &state.vz}) {
    component->assign(state.row(pups), Real(0));
  }
  state.bounds.assign(pups, {});
  state.tb.assign(pups, 0);
  state.felt_tb.assign(pups, 0);
  state.heading.assign(pups, 0);
  state.exposed.assign(pups, 1);
  state.touched.assign(state.flat(pups), -1);
  state.touching_points.assign(state.set(pups), 0);
  return state;
}

template <class Real>
bool update_bounds(State<Real>& state, int pup) {
  assert(pup >= 0 && pup < state.pups);
  const std::size_t row = state.row(pup);
  const Real* xyz[3] = {state.x.data() + row, state.y.data() + row, state.z.data() + row};
  Bounds<Real>& b = state.bounds[pup];
  return state.kernels->bounds(xyz, state.points, b.low, b.high, b.centre, &b.radius);
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

template <class Real>
void make_room(State<Real>& state, PartSet records) {
  if (records.has(Part::sides)) {
    for (auto* values : {&state.t_left, &state.t_right, &state.turn}) values->resize(state.pups);
    state.left.resize(state.flat(state.pups));
  }
  if (records.has(Part::strain)) state.strain.resize(state.flat(state.pups));
  if (records.has(Part::pose)) state.pose.resize(state.pups);
}

template struct State<float>;
template struct State<double>;
template State<float> make_state<float>(int, int, InstructionSet);
template State<double> make_state<double>(int, int, InstructionSet);
template bool update_bounds<float>(State<float>&, int);
template bool update_bounds<double>(State<double>&, int);
template void make_room<float>(State<float>&, PartSet);
template void make_room<double>(State<double>&, PartSet);
template std::uint64_t hash_state<float>(const State<float>&);
template std::uint64_t hash_state<double>(const State<double>&);

}  // namespace pupflow
