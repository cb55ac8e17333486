#include "bench/scenes.h"
#include "pupflow/simulation.h"

#include <cmath>
#include <deque>
#include <stdexcept>

namespace pupflow::bench {

Params huddling(Precision precision) {
  Params params;
  params.ambient_temperature = 0.2;
  params.precision = precision;
  return params;
}

Params dispersed(Precision precision) {
  Params params = huddling(precision);
  params.ambient_temperature = 0.8;
  return params;
}

Params crowd(int pups, Precision precision) {
  Params params = huddling(precision);
  params.pups = pups;
  params.start = Start::carpet;
  params.arena_radius *= std::sqrt(pups / 12.0);
  return params;
}

Simulation after(const Params& params, std::int64_t steps) {
  Simulation simulation(params);
  const Status status = simulation.run(steps);
  if (!status.ok()) throw std::runtime_error(status.message());
  return simulation;
}

const Simulation& settled(const Params& params) {
  static std::deque<Simulation> litters;
  for (const Simulation& litter : litters) {
    if (litter.params() == params) return litter;
  }
  litters.push_back(after(params, kSettled));
  return litters.back();
}

const char* precision_name(Precision precision) {
  return precision == Precision::float_ ? "float" : "double";
}

}  // namespace pupflow::bench
