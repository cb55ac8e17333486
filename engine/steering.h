// Steering: a pup turns towards the side whose temperature brings its own nearer to T_p.
//
//   S_L = 1 / (1 + exp(-sigma T_L (T_p - T_b)))      S_R likewise
//   turn = atan(v (S_L - S_R) / (S_L + S_R))
//
// T_L and T_R are the means of T_c over the points on the left (counter-clockwise of the heading,
// seen from above) and on the right. heading = course takes the sides about theta and turns it:
//
//   theta <- theta + h turn
//
// heading = body takes the sides about the body axis psi:
//
//   theta = psi + turn
//
// An action on the pup (schedule.h) may set its turn.
//
// Wilson 2017, Methods; docs/model.md, Steering.
#pragma once

#include "engine/cloud.h"
#include "engine/state.h"
#include "pupflow/parameters.h"
#include "pupflow/status.h"

namespace pupflow {

/// The turn for given temperatures, radians within +-pi/2. Finite for any finite input; 0 where
/// t_left = t_right. Right where an exponent overflows, too: if both sensors read next to nothing,
/// S_L/S_R is the exponential of the difference of the exponents; if both read 1, the turn is 0.
double turn(const Params& params, double tb, double t_left, double t_right);

/// Direction psi of a pup's own axis, from its first point (its tail) to its centre, in (-pi, pi].
/// A purely vertical axis gives 0.
template <class Real>
double body_axis(const Cloud<Real>& cloud, const State<Real>& state, int pup);

/// Means of T_c on both sides of `direction` (radians) about the pup's centre.
struct SideTemperatures {
  double left, right;
};
template <class Real>
SideTemperatures side_temperatures(const Params& params, const Cloud<Real>& cloud,
                                   const State<Real>& state, int pup, double direction);

/// The same about the body axis. The first point lies on that axis, so it is not on the left; said
/// here, since in the general case rounding would decide.
template <class Real>
SideTemperatures body_side_temperatures(const Params& params, const Cloud<Real>& cloud,
                                        const State<Real>& state, int pup);

/// What steering does for a pup (plan.h): work out the turn, set the heading, record what is felt.
struct SteeringParts {
  bool turn = true, direction = true, sides = false;
};

/// Steers one pup. Reads the body temperatures of others, so heat comes later. A turn of 0 is right
/// where v = 0 or sigma = 0; without `parts.turn` and `parts.sides` what the pup touches is not
/// read. `parts.sides` fills left, t_left, t_right and turn of the state, which must have room
/// (make_room).
template <class Real>
Status steer(const Params& params, SteeringParts parts, const Cloud<Real>& cloud,
             State<Real>& state, int pup);

}  // namespace pupflow
