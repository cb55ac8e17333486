// The litters that are measured.
#pragma once

#include "pupflow/simulation.h"

namespace pupflow::bench {

/// Steps after which the paper's litter has landed and huddles or has spread.
constexpr std::int64_t kSettled = 500;

/// The paper's litter, seed 1, at T_a = 0.2 (huddling) and at T_a = 0.8 (dispersed).
Params huddling(Precision precision);
Params dispersed(Precision precision);

/// Many pups at the paper's density, on a carpet: the arena's floor grows with their number.
Params crowd(int pups, Precision precision);

/// `params` after `steps` steps. Throws std::runtime_error on a bad status.
Simulation after(const Params& params, std::int64_t steps);

/// `params` after kSettled steps; computed once and kept.
const Simulation& settled(const Params& params);

/// "float" or "double".
const char* precision_name(Precision precision);

}  // namespace pupflow::bench
