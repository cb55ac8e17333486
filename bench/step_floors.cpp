// How far a step is from what the machine allows: from its rate of memory, with many pups, and from
// the least that a contact search compares.
#include <algorithm>
#include <cstdio>

#include "bench/floors.h"
#include "bench/measure.h"
#include "bench/scenes.h"
#include "bench/sections.h"
#include "engine/lanes.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

constexpr int kCrowd = 10000;
constexpr int kCrowdSteps = 3, kSteps = 200;  // in a round

// Component arrays of the points that go through memory in a step of many pups. Each pass over the
// litter finds its arrays out of the caches again.
constexpr int kBoundaryRows = 4;  // z and v_z, read and written
constexpr int kSearchRows = 3;    // x, y and z, read
constexpr int kMotionRows = 12;   // positions and velocities, read and written
constexpr int kStepRows = kBoundaryRows + kSearchRows + kMotionRows;

/// The positions and velocities of many pups.
template <class Real>
class Crowd {
 public:
  explicit Crowd(int points) : stride_(stride_for<Real>(points)) {
    for (auto& row : rows_) row.assign(static_cast<std::size_t>(kCrowd) * stride_, Real(1));
  }

  /// Bytes of a row of one pup.
  double row_bytes() const { return static_cast<double>(stride_ * sizeof(Real)); }

  /// Bytes a microsecond of the kernel `predict`, which reads and writes six rows of every pup.
  double memory_rate(const TightKernels<Real>& kernels) {
    const double time = busy_microseconds([&] {
      const Real gain[3] = {0, 0, 0};
      for (int j = 0; j < kCrowd; ++j) kernels.predict(pup(j), gain, Real(0));
    });
    return kMotionRows * row_bytes() * kCrowd / time;
  }

 private:
  TightPup<Real> pup(int number) {
    const auto at = [&](int row) {
      return rows_[row].data() + static_cast<std::size_t>(number) * stride_;
    };
    return {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}, stride_};
  }

  int stride_;
  AlignedVector<Real> rows_[6];
};

template <class Real>
constexpr Precision kPrecision = sizeof(Real) == sizeof(float) ? Precision::float_
                                                               : Precision::double_;

template <class Real>
void floor_of_memory(int rounds) {
  const TightVariant<Real> variant = tight_variants<Real>().back();
  Simulation simulation = settled(crowd(kCrowd, kPrecision<Real>));
  Crowd<Real> arrays(simulation.points());
  std::vector<double> step, rate, floor;
  for (int round = 0; round < rounds; ++round) {
    rate.push_back(arrays.memory_rate(*variant.kernels));
    floor.push_back(kStepRows * arrays.row_bytes() / rate.back());
    step.push_back(busy_microseconds([&] { simulation.run(kCrowdSteps); }) / kCrowdSteps / kCrowd);
  }
  std::printf(
      "- **Memory**, %d pups in %s. A step moves %d rows of %.2f kB a pup: %d in the boundaries, "
      "%d in"
      " the contact search, %d in all stages behind it. The tight kernel `predict` moves %.1f GB/s"
      " over as many pups. So a step needs at least %.2f µs a pup; it takes %.2f, %.1f times as"
      " long.\n",
      kCrowd, precision_name(kPrecision<Real>), kStepRows, 1e-3 * arrays.row_bytes(), kBoundaryRows,
      kSearchRows, kMotionRows, 1e-3 * median(rate), median(floor), median(step),
      ratio(step, floor));
}

template <class Real>
void floor_of_contacts(int rounds) {
  const TightVariant<Real> variant = tight_variants<Real>().back();
  const Simulation& start = settled(huddling(kPrecision<Real>));
  TightLitter<Real> tight(start.snapshot());
  const auto least = tight.least_search(variant.kernels->group);
  std::vector<double> stage, looking, comparing, floor;
  for (int round = 0; round < rounds; ++round) {
    Simulation simulation = start;
    stage.push_back(stage_times(simulation, kSteps)[static_cast<std::size_t>(Stage::contact)]);
    const Floors tightly = tight.measure(*variant.kernels);
    looking.push_back(tightly.bounds / tight.pups() * least.pups);
    comparing.push_back(tightly.distances / tight.distance_tests() * least.points);
    floor.push_back(looking.back() + comparing.back());
  }
  std::printf(
      "- **Contacts**, T_a = 0.2 in %s. A search without memory of the step before looks through "
      "the"
      " points of both pups of each near pair, %.0f pups in all: %.2f µs at the rate of the kernel"
      " `bounds`. In groups of %d points it compares at least the %.0f pairs of a point and a group"
      " that touch: %.2f µs at the rate of `distances`. The stage takes %.1f µs, %.1f times"
      " as long as both.\n",
      precision_name(kPrecision<Real>), least.pups, median(looking), variant.kernels->group,
      least.points, median(comparing), median(stage), ratio(stage, floor));
}

}  // namespace

void step_floors(int rounds, Verdicts&) {
  floor_of_memory<float>(rounds);
  floor_of_memory<double>(rounds);
  floor_of_contacts<float>(rounds);
  floor_of_contacts<double>(rounds);
}

}  // namespace pupflow::bench
