/// @file
/// Many independent runs on any number of threads, which changes no bit of the results.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "pupflow/observer.h"
#include "pupflow/parameters.h"
#include "pupflow/status.h"

#pragma GCC visibility push(default)
namespace pupflow {

/// What was seen after one step of a run.
struct Sample {
  std::int64_t step;  ///< steps done
  double time;        ///< model seconds
  Observables seen;   ///< after that step
};

/// The result of a whole run.
struct RunResult {
  Status status;               ///< of the last step; if it is bad, the means are not valid
  Observables means;           ///< over the steps after `discard`
  double exposed_sd = 0;       ///< standard deviation of a pup's A over time, mean over pups
  Warnings warnings;           ///< of the steps that were taken
  std::int64_t steps = 0;      ///< that were taken
  std::uint64_t hash = 0;      ///< of the litter after them (Simulation::hash)
  std::vector<Sample> series;  ///< after steps N, 2 N, ... for series_every = N
};

/// Runs `params.steps` steps, or to the first bad status. The litter is observed only as the means
/// need it, from flow_lag steps before they begin, or from the start where a series is wanted
/// (series_every > 0), which changes no other number of the result. `stop` is called between steps;
/// when it returns true, the run ends without a result. Throws InvalidParams.
std::optional<RunResult> run_to_end(const Params& params, const std::function<bool()>& stop,
                                    std::int64_t series_every = 0);

/// Calls `body` with each of 0 ... count - 1 once (never where count is 0 or less), on `threads` threads (at least 1), in no fixed
/// order. After an exception in `body` no further index is begun; the first exception is thrown
/// here when all threads have ended.
void for_each_index(std::int64_t count, int threads, const std::function<void(std::int64_t)>& body);

/// The runs 0 ... count - 1 with the parameters `params_of(run)`, on `threads` threads (at least
/// 1). `deliver` gets each result when it is ready, one call at a time, in no fixed order. `stop`
/// is called by all threads at any time. Returns when all runs are done or stopped. After an
/// exception in any of the three functions, or InvalidParams, all runs end at their next step and
/// the exception is thrown here.
void run_ensemble(std::int64_t count, int threads,
                  const std::function<Params(std::int64_t)>& params_of,
                  const std::function<void(std::int64_t, const RunResult&)>& deliver,
                  const std::function<bool()>& stop, std::int64_t series_every = 0);

/// The seed of a run: a function of base seed and run number alone, different for every run of a
/// sweep of up to 2^31 runs.
std::int64_t run_seed(std::int64_t base_seed, std::int64_t run);

}  // namespace pupflow
#pragma GCC visibility pop
