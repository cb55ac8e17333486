// Long and large work in one process: what it holds of memory, descriptors and threads stays what it
// was. PUPFLOW_LOAD=N makes the long ones N times as long.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "app/io/checkpoint.h"
#include "app/io/csv.h"
#include "app/io/provenance.h"
#include "app/io/recording.h"
#include "pupflow/ensemble.h"
#include "pupflow/observer.h"
#include "pupflow/simulation.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

std::int64_t times() {
  const char* text = std::getenv("PUPFLOW_LOAD");
  return text ? std::max(1L, std::atol(text)) : 1;
}

/// What this process holds.
struct Holdings {
  long kilobytes = 0, descriptors = 0, threads = 0;
};

long number_in_status(const std::string& label) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(label)) return std::atol(line.c_str() + label.size());
  }
  ADD_FAILURE() << "no " << label;
  return 0;
}

Holdings holdings() {
  const std::filesystem::directory_iterator open("/proc/self/fd");
  return {number_in_status("VmRSS:"),
          static_cast<long>(std::distance(open, std::filesystem::directory_iterator())),
          number_in_status("Threads:")};
}

/// Memory may grow by what an allocator keeps back.
void expect_flat(const Holdings& before, const Holdings& after) {
  constexpr long kKept = 2048;
  EXPECT_LE(after.kilobytes, before.kilobytes + kKept);
  EXPECT_EQ(after.descriptors, before.descriptors);
  EXPECT_EQ(after.threads, before.threads);
  ::testing::Test::RecordProperty("kilobytes_before", static_cast<int>(before.kilobytes));
  ::testing::Test::RecordProperty("kilobytes_after", static_cast<int>(after.kilobytes));
  std::cout << "memory " << before.kilobytes << " kB, then " << after.kilobytes << " kB\n";
}

Params small() {
  Params params;
  params.pups = 3;
  params.face_points = 2;
  params.steps = 10;
  params.discard = 0;
  return params;
}

TEST(Load, TenThousandRunsInOneProcess) {
  const auto run_all = [](std::int64_t count) {
    std::int64_t done = 0;
    run_ensemble(
        count, 2,
        [](std::int64_t run) {
          Params params = small();
          params.seed = run;
          params.pups = 1 + static_cast<int>(run % 7);
          return params;
        },
        [&](std::int64_t, const RunResult& result) { done += result.steps > 0 ? 1 : 0; },
        [] { return false; }, 2);
    EXPECT_EQ(done, count);
  };
  run_all(1000);
  const Holdings before = holdings();
  run_all(10'000 * times());
  expect_flat(before, holdings());
}

TEST(Load, ManyRunsThatWriteFiles) {
  const test::Scratch scratch;
  const auto run_all = [&](std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) {
      Simulation litter(small());
      Observer observer(litter);
      io::MetricsCsv csv(scratch.path("a.csv"), true, litter);
      io::Recording recording(scratch.path("a.h5"), true, litter.recipe(), io::provenance(litter),
                              io::parse_recorded_fields("pup"));
      for (int step = 0; step < 3; ++step) {
        litter.step();
        csv.add(litter, observer.observe(litter));
        recording.add(litter);
      }
      csv.file().commit();
      recording.commit("");
      io::write_checkpoint(scratch.path("b.h5"), true, litter);
      EXPECT_EQ(io::read_checkpoint(scratch.path("b.h5")).step, 3);
    }
  };
  run_all(30);
  const Holdings before = holdings();
  run_all(150 * times());
  expect_flat(before, holdings());
}

/// A hundredth of a day of model time, so with PUPFLOW_LOAD=100 a day.
TEST(Load, ADayOfOneLitter) {
  Params params = small();
  const std::int64_t hundredth = std::llround(864 / params.dt);
  params.steps = 2 * hundredth * times();
  Simulation litter(params);
  Observer observer(litter);
  RunMeans means(0);
  const auto step = [&](std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) {
      ASSERT_TRUE(litter.step().ok()) << litter.status().message();
      means.add(litter, observer.observe(litter));
    }
  };
  step(1000);
  const Holdings before = holdings();
  step(hundredth * times());
  std::cout << hundredth * times() << " steps\n";
  expect_flat(before, holdings());
  EXPECT_TRUE(litter.warnings().empty());
}

TEST(Load, TenThousandPups) {
  Params params;
  params.pups = 10'000;
  params.face_points = 2;
  params.start = Start::carpet;
  params.arena_radius = 60;
  Simulation litter(params);
  litter.set_threads(2);
  ASSERT_TRUE(litter.run(2).ok()) << litter.status().message();
  const Holdings before = holdings();
  ASSERT_TRUE(litter.run(8 * times()).ok()) << litter.status().message();
  const Holdings after = holdings();
  EXPECT_LE(after.kilobytes, before.kilobytes + before.kilobytes / 10);
  EXPECT_EQ(after.threads, before.threads);
}

}  // namespace
}  // namespace pupflow
