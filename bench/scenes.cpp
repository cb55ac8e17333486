#include "bench/scenes.h"
#include "pupflow/simulation.h"

#include <cmath>
#include <cstdio>
#include <deque>
#include <stdexcept>

namespace pupflow::bench {

Params litter(double ambient_temperature, Precision precision) {
  Params params;
  params.ambient_temperature = ambient_temperature;
  params.precision = precision;
  return params;
}

Params huddling(Precision precision) {
  return litter(0.2, precision);
}

Params dispersed(Precision precision) {
  return litter(0.8, precision);
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

const Simulation& settled(const Params& params, std::int64_t steps) {
  static std::deque<Simulation> litters;
  for (const Simulation& litter : litters) {
    if (litter.params() == params && litter.steps_done() == steps) return litter;
  }
  litters.push_back(after(params, steps));
  return litters.back();
}

const char* precision_name(Precision precision) {
  return precision == Precision::float_ ? "float" : "double";
}

std::string temperature_name(double ambient_temperature) {
  char text[32];
  std::snprintf(text, sizeof text, "T_a %.1f", ambient_temperature);
  return text;
}

}  // namespace pupflow::bench
