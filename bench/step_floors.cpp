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

/// A step of many pups and what its memory allows, each a pup.
struct MemoryFloor {
  double kilobytes, gigabytes_a_second, floor, step, times;
};

template <class Real>
MemoryFloor floor_of_memory(int rounds) {
  const TightVariant<Real> variant = tight_variants<Real>().back();
  Simulation simulation = settled(crowd(kCrowd, kPrecision<Real>), kLanded);
  Crowd<Real> arrays(simulation.points());
  const double bytes = kStepRows * arrays.row_bytes();
  std::vector<double> step, rate, floor;
  for (int round = 0; round < rounds; ++round) {
    rate.push_back(arrays.memory_rate(*variant.kernels));
    floor.push_back(bytes / rate.back());
    step.push_back(busy_microseconds([&] { simulation.run(kCrowdSteps); }) / kCrowdSteps / kCrowd);
  }
  return {1e-3 * bytes, 1e-3 * median(rate), median(floor), median(step), ratio(step, floor)};
}

void print_memory(const MemoryFloor& f, const MemoryFloor& d) {
  std::printf(
      "- **Memory.** A step of %d pups moves %d of the arrays of their points through memory (%d in"
      " the boundaries, %d in the contact search, %d in the stages behind it): %.1f kB a pup in"
      " float, %.1f in double. The tight kernel `predict` moves %.1f and %.1f GB/s over as many"
      " pups, so a step needs at least %.2f and %.2f µs a pup. It takes %.2f and %.2f: %.1f and "
      "%.1f"
      " times as long.\n",
      kCrowd, kStepRows, kBoundaryRows, kSearchRows, kMotionRows, f.kilobytes, d.kilobytes,
      f.gigabytes_a_second, d.gigabytes_a_second, f.floor, d.floor, f.step, d.step, f.times,
      d.times);
}

/// The contact stage of the huddling litter and the least that its search compares.
struct SearchFloor {
  int group;
  double pups, points, floor, stage, times;
};

template <class Real>
SearchFloor floor_of_search(int rounds) {
  const TightVariant<Real> variant = tight_variants<Real>().back();
  const Simulation& start = settled(huddling(kPrecision<Real>));
  TightLitter<Real> tight(start.snapshot());
  const int group = variant.kernels->group;
  const auto least = tight.least_search(group);
  std::vector<double> stage, floor;
  for (int round = 0; round < rounds; ++round) {
    Simulation simulation = start;
    stage.push_back(stage_times(simulation, kSteps)[static_cast<std::size_t>(Stage::contact)]);
    const Floors times = tight.measure(*variant.kernels);
    floor.push_back(times.bounds / tight.pups() * least.pups +
                    times.distances / tight.distance_tests() * least.points);
  }
  return {group, least.pups, least.points, median(floor), median(stage), ratio(stage, floor)};
}

void print_search(const SearchFloor& f, const SearchFloor& d) {
  std::printf(
      "- **Contacts**, T_a = 0.2. A search that remembers nothing of the step before looks through"
      " the points of both pups of every near pair, %.0f pups in all. In groups of %d points it "
      "then"
      " compares each point with the groups that it touches: %.0f pairs of points in float, %.0f in"
      " double. At the rates of the tight kernels `bounds` and `distances` both take %.1f and %.1f"
      " µs; the contact stage takes %.1f and %.1f, %.1f and %.1f times as long.\n",
      f.pups, f.group, f.points, d.points, f.floor, d.floor, f.stage, d.stage, f.times, d.times);
}

}  // namespace

void step_floors(int rounds, Verdicts&) {
  print_memory(floor_of_memory<float>(rounds), floor_of_memory<double>(rounds));
  print_search(floor_of_search<float>(rounds), floor_of_search<double>(rounds));
}

}  // namespace pupflow::bench
