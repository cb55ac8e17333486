// Watches a litter for impossible states (warning.h).
//
// A pup's middle is the middle of its box, which a step keeps true anyway, so a look at a pup costs
// some ten operations and no look at its points.
//
// sunk, outside: its middle is under the floor (z < 0), or further than arena_radius from the axis.
// A hard landing or a hard hit on the wall does that for a few steps. So it counts only where it
// lasts: after 50 steps on end, or later where it comes and goes, but never for a quarter of the
// time or less.
//
// hanging: a body that falls from rest by a pup radius r reaches u = sqrt(2 g r). A thrown body is
// slower than u, up or down, for a time of 2 u / g, and one that bounces without ever being faster
// stays within r of what it bounces on. So a pup that has been slower than u for longer, with
// nothing within r, is held by nothing and does not fall. "Nothing": its box is further than r from
// the floor and from the box of everybody who stands on the floor or is within r of such a one, and
// so on. This must be found twice, 2 u / g (at least 50 steps) apart, since whatever carried it may
// just have left. Without gravity nothing hangs.
//
// gaining_energy: floor, wall and contacts take energy from falling pups. With E the largest g z +
// v^2 / 2 of a pup at the start, 2 R f the work that the drive can do across the arena, and 1/2 for
// the wall, which pushes with speed 1, nobody rises above
//
//     (E + 2 R f + 1/2) / g
//
// but on top of others, which ends where all stand on each other at 2 N (r_pup + r_point). The
// limit is 3/2 of the higher one: a landing gains up to h v of height, because the floor lifts
// points to where they should have stopped. Speed is not looked at: with gravity it turns into
// height, and sideways it ends at the wall, or beyond it.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/broad_phase.h"
#include "engine/params.h"
#include "engine/state.h"
#include "engine/warning.h"

namespace pupflow {

template <class Real>
class Watch {
 public:
  /// Takes the litter as it is as the start of what can be judged: call it before the first step,
  /// and when parameters or pups were set by hand. Warnings are kept.
  void begin(const Params& params, const State<Real>& state);

  /// Looks at the litter after a good step; its bounds must be true.
  void look(const Params& params, const State<Real>& state);

  const Warnings& warnings() const { return warnings_; }

 private:
  /// What is known of one pup.
  struct Past {
    double height = 0;       // of its middle
    int under = 0, out = 0;  // rise in each step under the floor or outside, and fall in others
    std::int64_t slow = 0;   // steps since its vertical speed was above u
    bool held_up = false;    // slow, and carried by nothing, when last looked for
  };

  void look_for_hanging(const Params& params, const State<Real>& state);
  bool is_airborne(const Params& params, const State<Real>& state, int pup) const;
  void find_carried(const Params& params, const State<Real>& state);

  Warnings warnings_;
  std::vector<Past> past_;
  double highest_ = 0;           // limit of height
  double slow_ = 0;              // u h, length in a step
  std::int64_t slow_steps_ = 0;  // between looks for pups that hang
  BroadPhase<Real> near_;
  std::vector<char> carried_;
};

}  // namespace pupflow
