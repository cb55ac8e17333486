// Who computes the runs of a sweep, where it is not the threads of this process alone.
#pragma once

#include <cstdint>
#include <functional>

#include "pupflow/ensemble.h"

namespace pupflow::study {

class Crew {
 public:
  virtual ~Crew() = default;

  /// Runs number 0 ... count - 1 of `params_of`, shared among the crew. `deliver` gets each result
  /// once, in no fixed order; it, like `params_of`, is called on this thread. `stop` may be asked
  /// by any thread at any time. Returns when all are done or `stop` says so. An exception of a
  /// callback, or of a run on this process, comes out of here.
  virtual void compute(std::int64_t count, const std::function<Params(std::int64_t)>& params_of,
                       const std::function<void(std::int64_t, const RunResult&)>& deliver,
                       const std::function<bool()>& stop) = 0;
};

}  // namespace pupflow::study
