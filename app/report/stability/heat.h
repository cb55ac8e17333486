// The runs of the maps of heat alone: pups that do not move.
#pragma once

#include <functional>
#include <optional>

#include "app/report/stability/class.h"

namespace pupflow::report {

/// One pup without contact goes from T_b(0) to its equilibrium T_e. Ringing: T_b - T_e changes its
/// sign in most steps. Diverged: a bad status, or |T_b - T_e| larger at the end than at the
/// beginning. `params` has one pup, and neither gravity nor drive. Empty when `stop` returns true.
std::optional<Trial> try_heat(const Params& params, const std::function<bool()>& stop);

/// The same for the difference of T_b of two pups that are held together, the first warmer at the
/// beginning. k1 and g must be 0, so that only k2 acts.
std::optional<Trial> try_exchange(const Params& params, const std::function<bool()>& stop);

/// The share of points in contact, 1 - A, of the two pups of `try_exchange`.
double held_contact(const Params& params);

}  // namespace pupflow::report
