// Runs held against each other seed by seed.
#include "app/report/error/paired.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pupflow/ensemble.h"

namespace pupflow::report {
namespace {

using ::testing::HasSubstr;

Params small() {
  Params p;
  p.pups = 4;
  p.face_points = 4;
  p.ambient_temperature = 0.2;
  p.steps = 120;
  p.discard = 40;
  p.seed = 5;
  return p;
}

Paired compared(const Params& base, std::int64_t seeds = 3) {
  Options options;
  options.quiet = true;
  options.threads = 2;
  return compare({"test", changes_of(base, 2), seeds, {"huddling", "exposed_sd"}}, options);
}

const Compared& row(const Paired& paired, const std::string& label) {
  const auto found = std::find_if(paired.rows.begin(), paired.rows.end(),
                                  [&](const Compared& r) { return r.change.label == label; });
  if (found == paired.rows.end()) throw std::out_of_range("no row " + label);
  return *found;
}

RunResult run_of(Params params, std::int64_t seed) {
  params.seed = seed;
  return *run_to_end(params, [] { return false; });
}

TEST(Estimate, IntervalFactorIsStudentsT) {
  // Tables of the t distribution, 97.5 %.
  EXPECT_NEAR(interval_factor(2), 12.706, 0.001);
  EXPECT_NEAR(interval_factor(3), 4.303, 0.001);
  EXPECT_NEAR(interval_factor(5), 2.776, 0.001);
  EXPECT_NEAR(interval_factor(10), 2.262, 0.001);
  EXPECT_NEAR(interval_factor(41), 2.021, 0.001);
  EXPECT_NEAR(interval_factor(100001), 1.960, 0.001);
  EXPECT_TRUE(std::isnan(interval_factor(1)));
}

TEST(Estimate, IsMeanAndHalfOfTheInterval) {
  const Estimate estimate = estimate_of({1, 2, 3});
  EXPECT_DOUBLE_EQ(estimate.mean, 2);
  EXPECT_NEAR(estimate.interval, 4.303 / std::sqrt(3), 0.001);
  EXPECT_FALSE(estimate.beyond_chance());
  EXPECT_TRUE(estimate_of({1, 1.1, 0.9}).beyond_chance());
  EXPECT_TRUE(std::isnan(estimate_of({1}).interval));
  EXPECT_TRUE(std::isnan(estimate_of({}).mean));
}

TEST(Estimate, WordsHaveTheDigitsThatTheIntervalLeaves) {
  EXPECT_EQ(words_of({0.57134, 0.01234}), "0.571 ± 0.012");
  EXPECT_EQ(words_of({0.57134, 0.01234}, true), "+0.571 ± 0.012");
  EXPECT_EQ(words_of({-1234.5, 67.8}, true), "-1234 ± 68");
  EXPECT_EQ(words_of({0.5, 0}), "0.5 ± 0");
  EXPECT_EQ(words_of({std::nan(""), 1}), "-");
}

TEST(Paired, DifferencesAreThoseOfRunsOfTheSameSeed) {
  const Params base = small();
  const Paired paired = compared(base);
  Params coarse = base;
  coarse.dt *= 2, coarse.steps /= 2, coarse.discard /= 2;
  std::vector<double> means, differences;
  for (const std::int64_t seed : {5, 6, 7}) {
    means.push_back(run_of(base, seed).means.huddling);
    differences.push_back(run_of(coarse, seed).means.huddling - means.back());
  }
  EXPECT_EQ(paired.rows[0].means[0].mean, estimate_of(means).mean);
  EXPECT_EQ(paired.rows[0].means[0].interval, estimate_of(means).interval);
  const Compared& twice = row(paired, "dt = 0.02, naive");
  EXPECT_EQ(twice.change.params, coarse);
  EXPECT_EQ(twice.differences[0].mean, estimate_of(differences).mean);
  EXPECT_EQ(twice.differences[0].interval, estimate_of(differences).interval);
  EXPECT_GT(twice.seconds, 0);
}

TEST(Paired, WindowsOfOneRunAreThoseOfRunsOfTheirOwn) {
  const Params base = small();
  const Paired paired = compared(base, 2);
  int windows = 0;
  for (const Compared& r : paired.rows) {
    if (r.change.group != "window" && r.change.group != "run length") continue;
    ++windows;
    std::vector<double> means, sds;
    for (const std::int64_t seed : {5, 6}) {
      const RunResult result = run_of(r.change.params, seed);
      means.push_back(result.means.huddling);
      sds.push_back(result.exposed_sd);
    }
    EXPECT_EQ(r.means[0].mean, estimate_of(means).mean) << r.change.label;
    EXPECT_EQ(r.means[1].mean, estimate_of(sds).mean) << r.change.label;
  }
  EXPECT_EQ(windows, 5);
  EXPECT_EQ(row(paired, "steps 41 to 240").change.params.steps, 240);
  EXPECT_EQ(row(paired, "steps 121 to 200").change.params.discard, 120);
}

TEST(Paired, PupFlowOverALagIsThatOfRunsOfTheirOwn) {
  Params base = small();
  base.flow_lag = 10;
  Options options;
  options.quiet = true;
  options.threads = 2;
  const Paired paired = compare({"test", changes_of(base, 2), 2, {"flow"}}, options);
  for (const Compared& r : paired.rows) {
    if (r.change.group != "window") continue;
    std::vector<double> flows;
    for (const std::int64_t seed : {5, 6}) {
      flows.push_back(run_of(r.change.params, seed).means.flow);
    }
    EXPECT_EQ(r.means[0].mean, estimate_of(flows).mean) << r.change.label;
  }
}

TEST(Paired, WhatCannotBeRunSaysWhy) {
  Params rigid = small();
  rigid.rigidity = 1;
  rigid.face_points = 2;
  const Paired paired = compared(rigid, 2);
  EXPECT_THAT(row(paired, "dt = 0.005, consistent").trouble(2), HasSubstr("alpha must be below 1"));
  EXPECT_THAT(row(paired, "k = 1").trouble(2), HasSubstr("2 … 32"));
  EXPECT_TRUE(std::isnan(row(paired, "k = 1").differences[0].mean));
  EXPECT_EQ(row(paired, "k = 3").trouble(2), "");
  Params late = small();
  late.discard = 100;
  EXPECT_THAT(row(compared(late, 2), "60 steps").trouble(2), HasSubstr("leaves out all 60 steps"));
}

TEST(Paired, RunsWithAWarningAreCountedAndKept) {
  Params driven = small();
  driven.drive = 60;  // presses pups through the wall
  driven.steps = 200;
  const Paired paired = compared(driven, 2);
  EXPECT_EQ(paired.rows[0].warned, 2);
  EXPECT_THAT(paired.rows[0].trouble(2), HasSubstr("2 of 2 runs ended with a warning, the first "
                                                   "with outside the wall from step"));
  EXPECT_TRUE(std::isfinite(paired.rows[0].means[0].mean));
}

TEST(Paired, RunsThatFailAreCountedAndNotInTheMeans) {
  Params hot = small();
  hot.ambient_temperature = 0.7;
  hot.air_conductance = 300;  // with Euler heat beyond 2/h
  const Paired paired = compared(hot);
  EXPECT_EQ(paired.rows[0].bad, 0);
  EXPECT_EQ(row(paired, "euler").bad, 3);
  EXPECT_THAT(row(paired, "euler").trouble(3),
              AllOf(HasSubstr("3 of 3 runs failed"), HasSubstr("diverged at step")));
  EXPECT_TRUE(std::isnan(row(paired, "euler").means[0].mean));
}

TEST(Paired, AtTheReferenceStepBothRefinementsAreOneModel) {
  Params fine = small();
  fine.refinement = Refinement::consistent;
  for (const Change& change : changes_of(fine, 2)) {
    EXPECT_EQ(change.params == fine, change.group.empty()) << change.label;
    EXPECT_FALSE(change.params.dt == kReferenceStep &&
                 change.params.refinement == Refinement::naive)
        << change.label;
  }
}

TEST(Paired, ThreadsChangeNoResult) {
  Options one;
  one.quiet = true;
  const Params base = small();
  const Paired a = compare({"test", changes_of(base, 2), 2, {"flow"}}, one);
  Options two = one;
  two.threads = 3;
  const Paired b = compare({"test", changes_of(base, 2), 2, {"flow"}}, two);
  for (std::size_t r = 0; r < a.rows.size(); ++r) {
    if (!a.rows[r].refused.empty() || a.rows[r].bad > 0) continue;
    EXPECT_EQ(a.rows[r].means[0].mean, b.rows[r].means[0].mean) << a.rows[r].change.label;
  }
}

}  // namespace
}  // namespace pupflow::report
