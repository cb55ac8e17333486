// What the maps of heat alone judge: pups that nothing moves.
#pragma once

#include <functional>
#include <optional>

#include "app/report/stability/class.h"

namespace pupflow::report {

/// One pup that touches nobody goes from T_b(0) to its equilibrium. Ringing: T_b passes it from one
/// side to the other in most steps. Diverged: the status, or T_b further from it at the end than at
/// the beginning. `params` has one pup, and neither gravity nor drive. Nothing when `stop` says so.
std::optional<Trial> try_heat(const Params& params, const std::function<bool()>& stop);

/// Two pups held together, the first warmer at the beginning: the same of their difference. k1 and
/// g must be 0, so that nothing but k2 acts.
std::optional<Trial> try_exchange(const Params& params, const std::function<bool()>& stop);

/// The share of points in contact, 1 - A, of the two pups of `try_exchange`.
double held_contact(const Params& params);

}  // namespace pupflow::report
