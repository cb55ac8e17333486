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
// stays within r of what it bounces on. So a pup that has been slower than u for longer, with its
// box further than r from the floor and near no other box, neither falls nor is carried. It must be
// found so twice, 2 u / g (at least 50 steps) apart, since whatever carried it may just have left.
// Pups that touch slow each other's fall: a pile of 200 hovers for thousands of steps. That is how
// contacts work, so only a pup near nobody hangs. Near is within r or 4 r_point, twice the distance
// at which points touch. The list of touching pairs is not read: a step that nobody observes does
// not fill it. Without gravity nobody hangs.
//
// gaining_energy: a pup should not rise above what it has energy for. With E the largest
// g z + v^2 / 2 of a pup at the start, 2 R f the work that the drive can do across the arena, and
// 1/2 for the wall, which pushes with speed 1, that is
//
//     (E + 2 R f + 1/2) / g
//
// but on top of others it may stand as high as all of them on each other, 2 N (r_pup + r_point).
// The limit is 3/2 of the higher one, since a landing at speed v gains up to h v of height: the
// floor lifts points to where they should have stopped. Falls that make h v nearly as large as a
// pup gain without end. Speed is not looked at: with gravity it turns into height, and sideways it
// ends at the wall, or beyond it.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/state.h"
#include "pupflow/parameters.h"
#include "pupflow/status.h"

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
    bool held_up = false;    // slow and near nobody, when last looked for
  };

  void look_for_hanging(const Params& params, const State<Real>& state);

  Warnings warnings_;
  std::vector<Past> past_;
  double highest_ = 0;           // limit of height
  double slow_move_ = 0;         // u h: who moves less up or down in a step is slow
  std::int64_t slow_steps_ = 0;  // between looks for pups that hang
};

}  // namespace pupflow
