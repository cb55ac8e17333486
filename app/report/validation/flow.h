// Pup flow over several lags.
#pragma once

#include <cstdint>
#include <vector>

#include "pupflow/parameters.h"

namespace pupflow::report {

constexpr std::int64_t kLags[] = {1, 10, 50, 100};

/// Flow over each of kLags: mean over pups and over the steps after `discard` of
/// |A(t) - A(t - lag h)| / (lag h). Behind them, of the changes of A from one step to the next that
/// are not zero, the share that is one point; and the share of pups and steps without a change.
std::vector<double> measure_flow(const Params& params);

}  // namespace pupflow::report
