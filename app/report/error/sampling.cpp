#include "app/report/error/sampling.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace pupflow::report {
namespace {

/// What reading the clock adds to a time.
double clock_seconds() {
  double least = 1;
  for (int i = 0; i < 100; ++i) {
    const double begin = thread_seconds();
    least = std::min(least, thread_seconds() - begin);
  }
  return least;
}

}  // namespace

double thread_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Outcome run_sampled(Simulation& simulation, int samples, std::size_t quantities, const Look& look,
                    const std::function<void(Simulation&)>& between) {
  const auto steps = static_cast<int>(std::lround(kSample / simulation.params().dt));
  const double clock = between ? clock_seconds() : 0;
  Outcome outcome;
  outcome.samples.resize(quantities);
  double spent = 0;
  const auto step = [&](int count) {
    const double begin = thread_seconds();
    for (int k = 0; k < count && outcome.status.ok(); ++k) outcome.status = simulation.step();
    spent += thread_seconds() - begin - clock;
  };
  for (int i = 0; i < samples && outcome.status.ok(); ++i) {
    stop_if_interrupted();
    if (!between) step(steps);
    for (int k = 0; between && k < steps && outcome.status.ok(); ++k) {
      step(1);
      between(simulation);
    }
    look(simulation, outcome.samples);
  }
  outcome.seconds = spent / (samples * kSample);
  return outcome;
}

}  // namespace pupflow::report
