#include "bench/scenes.h"

#include <stdexcept>

namespace pupflow::bench {

Params huddling(Precision precision) {
  Params params;
  params.ta = 0.2;
  params.precision = precision;
  return params;
}

Params dispersed(Precision precision) {
  Params params = huddling(precision);
  params.ta = 0.8;
  return params;
}

Simulation after(const Params& params, std::int64_t steps) {
  Simulation simulation(params);
  const Status status = simulation.run(steps);
  if (!status.ok()) throw std::runtime_error(status.message());
  return simulation;
}

}  // namespace pupflow::bench
