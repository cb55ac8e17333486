// The spring with which the mouse draws a pup.
#pragma once

#include <array>
#include <cstdint>

#include "pupflow/view.h"

namespace pupflow::window {

/// Steps for which one force is held: those of about 0.03 s, at least one.
std::int64_t pull_steps(double dt);

/// The acceleration, in arena units/s^2, that draws a pup's centre to `target` when it is held for
/// pull_steps(dt) steps:
///
///   a = w^2 d - 2 w v + (0, 0, g),   w = min(13/s, 1 / (2 T)),   T = pull_steps(dt) dt
///
/// d is the way to the target, at most 4 pup radii long, and v the velocity of the centre. The goals
/// of shape matching have the cloud's own mean, so for any alpha and beta the centre moves as one
/// point would, and this is a critically damped oscillator. It comes within a tenth of the way in
/// 3.9/w = 0.3 s. Held over T, the force is stable up to w T = 0.82, so half that is on the safe side
/// at any dt. The longest d bounds the speed by 2 w pup radii. The last term carries the weight. All
/// are rounded to five digits.
std::array<double, 3> pull_force(const LitterView& litter, int pup,
                                 const std::array<double, 3>& target);

}  // namespace pupflow::window
