#include "bench/litter_state.h"

#include <algorithm>

namespace pupflow::bench {

template <class Real>
State<Real> state_of(const Snapshot& snapshot) {
  State<Real> state = make_state<Real>(snapshot.params.pups, points_per_pup(snapshot.params));
  AlignedVector<Real>* const position[3] = {&state.x, &state.y, &state.z};
  AlignedVector<Real>* const velocity[3] = {&state.vx, &state.vy, &state.vz};
  for (int pup = 0; pup < state.pups; ++pup) {
    for (int i = 0; i < state.stride; ++i) {
      const std::size_t from = 3 * (state.flat(pup) + std::min(i, state.points - 1));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        (*position[axis])[state.row(pup) + i] = static_cast<Real>(snapshot.positions[from + axis]);
        (*velocity[axis])[state.row(pup) + i] = static_cast<Real>(snapshot.velocities[from + axis]);
      }
    }
    update_bounds(state, pup);
  }
  return state;
}

template State<float> state_of<float>(const Snapshot&);
template State<double> state_of<double>(const Snapshot&);

}  // namespace pupflow::bench
