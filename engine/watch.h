// Watches a litter for impossible states (Warning, status.h).
//
// The middle of a pup is the middle of its box, which a step keeps valid anyway. So a look at a pup
// takes some ten operations and reads none of its points.
//
// sunk, outside: the middle is under the floor (z < 0), or further than arena_radius from the axis.
// A hard landing or a hard hit on the wall does that for a few steps. Therefore it counts only
// where it lasts: after 50 successive steps, or later if it comes and goes. It never counts if it
// is so in a quarter of the steps or fewer.
//
// hanging: let r be the pup radius. A body that falls from rest by r reaches the speed
//
//   u = sqrt(2 g r)
//
// A body in free flight is slower than u, up or down, for at most the time 2 u / g. A body that
// bounces and is never faster than u stays within r of what it bounces on. So a pup neither falls
// nor is supported if it has been slower than u for longer than 2 u / g, its box is further than r
// from the floor, and no other box is near. It is reported when this is so at two successive looks,
// 2 u / g (at least 50 steps) apart, since its support may just have moved away.
//
// Pups that touch slow each other's fall: a pile of 200 hovers for thousands of steps. This follows
// from the contact rule, so only a pup with no other near it is reported. Near means within r or
// 4 r_point, which is twice the distance at which points touch. The list of touching pairs is not
// used: steps that are not observed do not fill it. Without gravity no pup is reported.
//
// gaining_energy: a pup cannot rise above the height for which it has energy,
//
//   (E + 2 R f + 1/2) / g
//
//   E     = the largest g z + v^2 / 2 of a pup at the start
//   2 R f = the largest work of the drive, across the arena
//   1/2   = the energy from the wall, which pushes with speed 1
//
// On top of the others it can be as high as a column of all pups, 2 N (r_pup + r_point). The limit
// is 3/2 of the larger of the two, since a landing at speed v gains up to h v of height: the floor
// lifts points to where they should have stopped. Where h v is nearly as large as a pup, falls gain
// height without end. Speed is not checked: with gravity it turns into height, and sideways it ends
// at the wall or beyond it.
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
  /// Takes the litter as it is as the start. To be called before the first step, and after
  /// parameters or pups were set from outside. Warnings are kept.
  void begin(const Params& params, const State<Real>& state);

  /// Looks at the litter after a step with a fine status. Its bounds must be valid.
  void look(const Params& params, const State<Real>& state);

  const Warnings& warnings() const { return warnings_; }

 private:
  /// What earlier steps left of one pup.
  struct Past {
    double height = 0;       // of its middle
    int under = 0, out = 0;  // counters of steps under the floor and outside (watch.cpp, lasts)
    std::int64_t slow = 0;   // steps since its vertical speed was above u
    bool held_up = false;    // slow, high and with no other near, at the last look
  };

  void look_for_hanging(const Params& params, const State<Real>& state);

  Warnings warnings_;
  std::vector<Past> past_;
  double highest_ = 0;           // limit of height
  double slow_move_ = 0;         // u h: a pup that moves less up or down in a step is slow
  std::int64_t slow_steps_ = 0;  // between looks for pups that hang
};

}  // namespace pupflow
