// The litters that are measured.
#pragma once

#include <string>

#include "pupflow/simulation.h"

namespace pupflow::bench {

/// Steps after which a litter has landed.
constexpr std::int64_t kLanded = 500;
/// Steps after which the paper's litter also huddles or has spread.
constexpr std::int64_t kSettled = 800;

/// The paper's litter, seed 1.
Params litter(double ambient_temperature, Precision precision);

/// That at T_a = 0.2 (huddling) and at T_a = 0.8 (dispersed).
Params huddling(Precision precision);
Params dispersed(Precision precision);

/// Many pups at the paper's density, on a carpet: the arena's floor grows with their number.
Params crowd(int pups, Precision precision);

/// `params` after `steps` steps. Throws std::runtime_error on a bad status.
Simulation after(const Params& params, std::int64_t steps);

/// `params` after `steps` steps; computed once and kept.
const Simulation& settled(const Params& params, std::int64_t steps = kSettled);

/// "float" or "double".
const char* precision_name(Precision precision);

/// "T_a 0.2"
std::string temperature_name(double ambient_temperature);

}  // namespace pupflow::bench
