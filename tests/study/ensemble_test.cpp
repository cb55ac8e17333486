#include "engine/ensemble.h"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <stdexcept>

#include "tests/study/small_design.h"

namespace pupflow {
namespace {

constexpr auto kNever = [] { return false; };

Params litter(std::int64_t i) {
  Params params = study::test::small_litter();
  params.seed = i + 1;
  return params;
}

std::map<std::int64_t, RunResult> results_with(int threads) {
  std::map<std::int64_t, RunResult> results;
  const auto deliver = [&](std::int64_t i, const RunResult& r) {
    EXPECT_TRUE(results.emplace(i, r).second) << "run " << i << " came twice";
  };
  run_ensemble(20, threads, litter, deliver, kNever);
  return results;
}

TEST(Ensemble, ComesToTheSameNumbersOnAnyNumberOfThreads) {
  const auto one = results_with(1);
  ASSERT_EQ(one.size(), 20u);
  EXPECT_NE(one.at(0).means.mean_tb, one.at(1).means.mean_tb);
  for (const int threads : {0, 2, 8, 64}) {
    const auto many = results_with(threads);
    ASSERT_EQ(many.size(), 20u);
    for (const auto& [i, result] : one) {
      EXPECT_EQ(many.at(i).means.mean_tb, result.means.mean_tb);
      EXPECT_EQ(many.at(i).means.flow, result.means.flow);
      EXPECT_EQ(many.at(i).means.membership_flow, result.means.membership_flow);
      EXPECT_EQ(many.at(i).exposed_sd, result.exposed_sd);
    }
  }
}

TEST(Ensemble, ReportsTheMeansThatARunItselfComesTo) {
  const Params params = litter(3);
  Simulation simulation(params);
  Observer observer(simulation);
  RunMeans means(params.discard);
  while (simulation.steps_done() < params.steps && simulation.step().ok()) {
    means.add(simulation, observer.observe(simulation));
  }
  const auto result = run_to_end(params, kNever);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->status.ok());
  EXPECT_EQ(result->means.mean_tb, means.means().mean_tb);
  EXPECT_EQ(result->means.huddling, means.means().huddling);
  EXPECT_EQ(result->means.flow, means.means().flow);
  EXPECT_EQ(result->exposed_sd, means.exposed_sd());
}

TEST(Ensemble, EndsARunWhereItsNumbersGoWrong) {
  Params params = litter(0);
  params.heat = HeatRule::euler;
  params.k1 = 500;  // each step overshoots by more than the one before
  params.steps = 2000;
  const auto result = run_to_end(params, kNever);
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->status.ok());
  EXPECT_LT(result->status.step, 2000);
}

TEST(Ensemble, DeliversNothingMoreOnceStopped) {
  for (const int threads : {1, 4}) {
    std::atomic<int> delivered{0};
    run_ensemble(
        1000, threads, litter, [&](std::int64_t, const RunResult&) { ++delivered; },
        [&] { return delivered >= 5; });
    EXPECT_GE(delivered, 5);
    EXPECT_LT(delivered, 5 + threads);
  }
  EXPECT_FALSE(run_to_end(litter(0), [] { return true; }));
}

TEST(Ensemble, PassesOnAnExceptionOfAnyCallback) {
  for (const int threads : {1, 4}) {
    int delivered = 0;
    const auto count = [&](std::int64_t, const RunResult&) { ++delivered; };
    const auto fail = [](const auto&...) { throw std::runtime_error("disk full"); };
    EXPECT_THROW(run_ensemble(
                     1000, threads, litter,
                     [&](std::int64_t, const RunResult&) {
                       if (++delivered == 3) fail();
                     },
                     kNever),
                 std::runtime_error);
    EXPECT_EQ(delivered, 3);  // and none after it
    EXPECT_THROW(run_ensemble(
                     1000, threads,
                     [&](std::int64_t i) {
                       if (i == 2) fail();
                       return litter(i);
                     },
                     count, kNever),
                 std::runtime_error);
    EXPECT_THROW(run_ensemble(1000, threads, litter, count,
                              [&]() -> bool { throw std::runtime_error("asked"); }),
                 std::runtime_error);
  }
}

TEST(Ensemble, RefusesUnsoundParameters) {
  Params params = litter(0);
  params.alpha = 7;
  EXPECT_THROW(run_to_end(params, kNever), InvalidParams);
}

TEST(Ensemble, OfNothingIsDoneAtOnce) {
  run_ensemble(
      0, 4, litter, [](std::int64_t, const RunResult&) { FAIL(); }, kNever);
}

}  // namespace
}  // namespace pupflow
