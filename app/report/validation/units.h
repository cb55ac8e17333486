// A litter in another unit of length.
#pragma once

#include "app/report/validation/runs.h"

namespace pupflow::report {

/// The parameters in another unit of length: lengths and accelerations times `scale`.
Params in_unit(Params params, double scale);

/// The litter of `params`, with the start of in_unit(params, 1 / scale) times `scale`, since the
/// rule for the start has lengths of its own.
Simulation scaled_litter(const Params& params, double scale);

/// When a litter and the same litter in another unit diverge.
struct Parting {
  std::int64_t contact = 0;  // the first step in which pups touch; 0 if none does
  std::int64_t step = 0;     // the first after which centres are more than 1e-6 apart; 0 if none is
};
/// Runs both for at most `most` steps.
Parting part_by_unit(const Params& params, double scale, std::int64_t most);

}  // namespace pupflow::report
