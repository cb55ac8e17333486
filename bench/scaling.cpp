// Cost of a pup and step, and memory of a pup, at constant density.
#include <algorithm>
#include <cstdio>

#include "bench/child.h"
#include "bench/measure.h"
#include "bench/scenes.h"
#include "bench/sections.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

constexpr int kSizes[] = {12, 100, 1000, 10000};
constexpr int kFewer = 2000, kMore = 10000;  // pups, between which memory is compared
constexpr int kMemorySteps = 200;            // until they lie on the floor and many touch
constexpr int kPupSteps = 10000;             // work of one measurement

struct Crowd {
  Simulation simulation;
  std::vector<double> pup_step;  // microseconds, one a round

  int pups() const { return simulation.pups(); }
};

/// Microseconds of processor time a pup and step.
double pup_step_time(Crowd& crowd) {
  const int steps = std::max(3, kPupSteps / crowd.pups());
  const double time = busy_microseconds([&] { crowd.simulation.run(steps); });
  return time / steps / crowd.pups();
}

template <Precision kPrecision>
void stand_a_crowd(int pups) {
  after(crowd(pups, kPrecision), kMemorySteps);
}

template <Precision kPrecision>
double bytes_a_pup() {
  const double few = peak_memory(stand_a_crowd<kPrecision>, kFewer);
  const double many = peak_memory(stand_a_crowd<kPrecision>, kMore);
  return (many - few) / (kMore - kFewer);
}

void measure_crowds(Precision precision, const char* name, int rounds, Verdicts& verdicts) {
  std::vector<Crowd> crowds;
  for (const int pups : kSizes) crowds.push_back({settled(crowd(pups, precision), kLanded), {}});
  for (int round = 0; round < rounds; ++round) {
    for (Crowd& crowd : crowds) crowd.pup_step.push_back(pup_step_time(crowd));
  }
  for (const Crowd& crowd : crowds) {
    const double touching = static_cast<double>(crowd.simulation.view().touching.size());
    std::printf("| %s, %d | %.2f | %.2f | %.2f | %s |\n", name, crowd.pups(),
                median(crowd.pup_step), ratio(crowd.pup_step, crowds.front().pup_step),
                touching / crowd.pups(), hash_text(crowd.simulation.hash()).c_str());
  }
  verdicts.measured(std::string("a pup's step, 10,000 through 12 pups, in ") + name,
                    ratio(crowds.back().pup_step, crowds.front().pup_step));
}

}  // namespace

void scaling(int rounds, Verdicts& verdicts) {
  const double in_float = bytes_a_pup<Precision::float_>() / 1e3;
  const double in_double = bytes_a_pup<Precision::double_>() / 1e3;
  std::printf("| memory | kB a pup |\n|---|---|\n| float | %.1f |\n| double | %.1f |\n", in_float,
              in_double);
  verdicts.measured("memory of a pup in float, kB", in_float);
  std::printf(
      "\n| pups | µs a pup and step | through that of 12 | touching pairs a pup | hash |\n");
  std::printf("|---|---|---|---|---|\n");
  measure_crowds(Precision::float_, "float", rounds, verdicts);
  measure_crowds(Precision::double_, "double", rounds, verdicts);
}

}  // namespace pupflow::bench
