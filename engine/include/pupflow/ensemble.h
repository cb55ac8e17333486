// Many independent runs, on as many threads as wanted; same bits whatever their number.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "pupflow/observer.h"
#include "pupflow/parameters.h"
#include "pupflow/status.h"

namespace pupflow {

/// What a whole run comes to.
struct RunResult {
  Status status;          // of the last step; when it is bad, the means are not to be used
  Observables means;      // over the steps after `discard`
  double exposed_sd = 0;  // standard deviation of a pup's A over time, mean over pups
  Warnings warnings;      // of the steps that were taken
};

/// Runs `params.steps` steps, or to the first bad status. The litter is observed only from where
/// the means need it: flow_lag steps before they begin. Nothing when `stop` (asked between steps)
/// told it to give up. Throws InvalidParams.
std::optional<RunResult> run_to_end(const Params& params, const std::function<bool()>& stop);

/// Runs number 0 ... count - 1 of `params_of`, on `threads` threads (at least 1). `deliver` gets
/// each result as it is ready, one call at a time, in no fixed order; `stop` is asked by all
/// threads at any time. Returns when all are done or stopped. An exception of any of the three ends
/// the others at their next step and comes out of here.
void run_ensemble(std::int64_t count, int threads,
                  const std::function<Params(std::int64_t)>& params_of,
                  const std::function<void(std::int64_t, const RunResult&)>& deliver,
                  const std::function<bool()>& stop);

/// The seed of a run: a pure function of base seed and run index, different for every run of a
/// sweep.
std::int64_t run_seed(std::int64_t base_seed, std::int64_t run);

}  // namespace pupflow
