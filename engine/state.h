// The litter's arrays, one array per component: what a step reads and writes.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/aligned.h"
#include "engine/kernels.h"
#include "engine/point_set.h"
#include "pupflow/snapshot.h"

namespace pupflow {

/// What encloses a pup's points: a box, and a ball round the middle of the box.
template <class Real>
struct Bounds {
  Real low[3], high[3];
  Real centre[3], radius;
};

/// Everything that the future of a litter depends on, and what the last step found out. Point i of
/// pup j is element j * stride + i of each component. Elements from `points` to `stride` are
/// padding: finite, and of no weight anywhere.
template <class Real>
struct State {
  int pups = 0;
  int points = 0;  // per pup
  int stride = 0;  // stride_for(points), lanes.h
  AlignedVector<Real> x, y, z;
  AlignedVector<Real> vx, vy, vz;
  std::vector<Bounds<Real>> bounds;  // one per pup

  // Per pup. Double in either precision: there are few of them.
  std::vector<double> tb;       // body temperature T_b
  std::vector<double> felt_tb;  // T_b before the heat stage of the last step
  std::vector<double> heading;  // direction of travel theta, in (-pi, pi]
  std::vector<double> exposed;  // share A of the points without contact

  std::vector<Action> actions;  // what is done to each pup in the next step; empty: nothing

  // Results of the contact stage.
  std::vector<int> touched;  // pup of the nearest touching point or -1; element j * points + i
  std::vector<std::uint64_t>
      touching_points;                 // the points that have one: a set per pup (point_set.h)
  std::vector<TouchingPair> touching;  // sorted

  // For observers; empty until a step records them.
  std::vector<double> t_left, t_right, turn;  // Part::sides, per pup
  std::vector<std::uint8_t> left;             // Part::sides; element j * points + i
  std::vector<PupPose> pose;                  // Part::pose, per pup
  std::vector<float> strain;                  // Part::strain; element j * points + i
  PartSet recorded;                           // what the last step recorded

  const Kernels<Real>* kernels = nullptr;  // the loops over these arrays, for this processor

  std::int64_t step = 0;
  Clock clock;

  /// What is done to `pup`.
  Action action(int pup) const { return actions.empty() ? Action{} : actions[pup]; }

  std::size_t row(int pup) const { return static_cast<std::size_t>(pup) * stride; }
  std::size_t flat(int pup) const { return static_cast<std::size_t>(pup) * points; }
  std::size_t set(int pup) const { return static_cast<std::size_t>(pup) * words_for(points); }
};

/// A litter at rest with all points at the origin, stepped by the kernels of `set`.
template <class Real>
State<Real> make_state(int pups, int points,
                       InstructionSet set = supported_instruction_sets().back());

/// Recomputes `bounds[pup]`. Returns false when a coordinate of the pup is not finite.
template <class Real>
bool update_bounds(State<Real>& state, int pup);

/// Makes room for those of `records` that only an observer reads.
template <class Real>
void make_room(State<Real>& state, PartSet records);

/// Hash of positions, velocities, temperatures, headings and step count.
template <class Real>
std::uint64_t hash_state(const State<Real>& state);

}  // namespace pupflow
