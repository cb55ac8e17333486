// The heat balance of a litter.
#pragma once

#include <vector>

#include "pupflow/parameters.h"

namespace pupflow::report {

/// Means over pups and over the steps after `discard`, per model second. With forward Euler they
/// add up: change = made - lost + exchanged.
struct HeatBalance {
  double change = 0;     // of T_b
  double made = 0;       // G
  double lost = 0;       // to the air, k1 A (T_b - T_a)
  double exchanged = 0;  // from other pups, -k2 (1 - A)(T_b - mean T_c)
  double moved = 0;      // its absolute value
};

/// Runs `params` with heat = euler.
HeatBalance heat_balance(Params params);

}  // namespace pupflow::report
