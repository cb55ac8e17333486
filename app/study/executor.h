// Computes the runs of a sweep in several processes.
#pragma once

#include <cstdint>
#include <functional>

#include "pupflow/ensemble.h"

namespace pupflow::study {

class Executor {
 public:
  virtual ~Executor() = default;

  /// Computes runs 0 ... count - 1, where `params_of(i)` gives the parameters of run i, with the
  /// series that run_to_end makes for `series_every`. `deliver`
  /// receives each result once, in any order. Both are called on the calling thread; `stop` may be
  /// called by any thread. Returns when all runs are finished or `stop` returns true. Throws what a
  /// callback throws, and what a run on this process throws.
  virtual void compute(std::int64_t count, const std::function<Params(std::int64_t)>& params_of,
                       const std::function<void(std::int64_t, const RunResult&)>& deliver,
                       const std::function<bool()>& stop, std::int64_t series_every) = 0;

  /// Lets the other processes end. To be called when there is nothing more to compute: they would
  /// take this one for lost while it writes and draws.
  virtual void release() = 0;
};

}  // namespace pupflow::study
