#include "pupflow/ensemble.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "pupflow/simulation.h"
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

TEST(ForEachIndex, TakesEachIndexOnceOnAnyNumberOfThreads) {
  for (const int threads : {0, 1, 3, 64}) {
    std::vector<std::atomic<int>> calls(40);
    for_each_index(40, threads, [&](std::int64_t i) { ++calls[static_cast<std::size_t>(i)]; });
    for (const std::atomic<int>& count : calls) EXPECT_EQ(count, 1) << threads << " threads";
    for_each_index(0, threads, [](std::int64_t) { ADD_FAILURE() << "there is no index"; });
  }
}

TEST(ForEachIndex, PassesOnAnExceptionAndBeginsNoFurtherIndex) {
  for (const int threads : {1, 3}) {
    std::atomic<int> calls = 0;
    const auto body = [&](std::int64_t i) {
      ++calls;
      if (i == 2) throw std::runtime_error("index 2");
    };
    try {
      for_each_index(100, threads, body);
      FAIL();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "index 2");
    }
    if (threads == 1) {
      EXPECT_EQ(calls, 3);
    }
  }
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

void expect_means_of_a_watched_run(const Params& params) {
  Simulation simulation(params);
  Observer observer(simulation);
  RunMeans means(params.discard);
  while (simulation.steps_done() < params.steps && simulation.step().ok()) {
    means.add(simulation, observer.observe(simulation));
  }
  const auto result = run_to_end(params, kNever);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->status.ok());
  for (const ObservableField& row : observables())
    EXPECT_EQ(result->means.*row.value, means.means().*row.value) << row.name;
  EXPECT_EQ(result->exposed_sd, means.exposed_sd());
}

TEST(Ensemble, ReportsTheMeansThatARunItselfComesTo) {
  for (const std::int64_t discard : {0, 1, 2, 5, 20}) {
    for (const std::int64_t lag : {1, 2, 5, 30}) {
      SCOPED_TRACE("discard " + std::to_string(discard) + ", lag " + std::to_string(lag));
      Params params = litter(3);
      params.discard = discard;
      params.flow_lag = lag;
      expect_means_of_a_watched_run(params);
    }
  }
}

TEST(Ensemble, ReportsThemWhereOnlyAnObserverAsksForContacts) {
  Params params = litter(3);
  params.drive = params.air_conductance = params.contact_conductance = params.thermogenesis = 0;
  params.arena_radius = 0.4;  // so small that they touch
  params.discard = 50;        // they touch by then, so that a contact not recorded shows
  params.flow_lag = 3;
  expect_means_of_a_watched_run(params);
  EXPECT_GT(run_to_end(params, kNever)->means.huddling, 0);
}

TEST(Ensemble, ReportsTheSeriesOfARunAndTheSameMeans) {
  for (const std::int64_t lag : {1, 7, 30}) {
    Params params = litter(3);
    params.flow_lag = lag;
    const auto plain = run_to_end(params, kNever), recorded = run_to_end(params, kNever, 8);
    EXPECT_TRUE(plain->series.empty());
    ASSERT_EQ(recorded->series.size(), 7u);  // 8, 16, ... 56 of 60
    for (const ObservableField& row : observables())
      EXPECT_EQ(recorded->means.*row.value, plain->means.*row.value) << row.name;
    EXPECT_EQ(recorded->exposed_sd, plain->exposed_sd);
    Simulation simulation(params);
    Observer observer(simulation);
    for (const Sample& sample : recorded->series) {
      while (simulation.steps_done() < sample.step) {
        simulation.step();
        observer.observe(simulation);
      }
      EXPECT_EQ(sample.time, simulation.time());
      for (const ObservableField& row : observables()) {
        const double seen = observer.last().*row.value, there = sample.seen.*row.value;
        EXPECT_TRUE(there == seen || (std::isnan(there) && std::isnan(seen))) << row.name;
      }
    }
  }
}

TEST(Ensemble, LookingFromTheMiddleOnChangesNoBit) {
  for (const double drive : {0.0, 1.0}) {
    Params params = litter(3);
    params.drive = drive;
    if (drive == 0) params.air_conductance = params.contact_conductance = params.thermogenesis = 0;
    Simulation always(params), late(params);
    late.set_observed({});
    always.run(40);
    late.run(30);
    late.set_observed(kContactRecords);
    late.run(10);
    EXPECT_EQ(late.hash(), always.hash());
    EXPECT_EQ(late.view().exposed[0], always.view().exposed[0]);
  }
}

TEST(Ensemble, EndsARunWhereItsNumbersGoWrong) {
  Params params = litter(0);
  params.heat = HeatRule::euler;
  params.air_conductance = 500;  // each step overshoots by more than the one before
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
  params.rigidity = 7;
  EXPECT_THROW(run_to_end(params, kNever), InvalidParams);
}

TEST(Ensemble, OfNothingIsDoneAtOnce) {
  run_ensemble(
      0, 4, litter, [](std::int64_t, const RunResult&) { FAIL(); }, kNever);
}

}  // namespace
}  // namespace pupflow
