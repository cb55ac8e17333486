#include "app/window/session/history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "pupflow/simulation.h"

namespace pupflow::window {
namespace {

using Entry = History::Entry;

constexpr double kDt = 0.01;

/// Adds made-up steps to a history.
class Recorder {
 public:
  explicit Recorder(int pups = 2) : tb_(static_cast<std::size_t>(pups)) {}

  /// Steps `first` ... `last`. Groups is the step, T_b of pup i the step plus i.
  void add(std::int64_t first, std::int64_t last) {
    for (std::int64_t step = first; step <= last; ++step) {
      Observables seen;
      seen.groups = static_cast<double>(step);
      seen.flow =
          step == 1 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(step % 2);
      for (std::size_t i = 0; i < tb_.size(); ++i) tb_[i] = static_cast<double>(step + i);
      params_.ambient_temperature = static_cast<double>(step);
      const LitterView litter{params_, params_, static_cast<int>(tb_.size()),
                              1,       {},      {},
                              tb_,     {},      {},
                              {},      {},      {},
                              {},      {},      {},
                              {},      {},      {},
                              step,    0,       {}};
      history.add(step, static_cast<double>(step) * kDt, seen, litter);
    }
  }

  History history;

 private:
  std::vector<double> tb_;
  Params params_;
};

/// That the entries cover `first` ... `last` without gap or overlap.
void expect_covered(const std::vector<Entry>& entries, std::int64_t first, std::int64_t last) {
  ASSERT_FALSE(entries.empty());
  EXPECT_LE(entries.front().sample->first, first);
  EXPECT_GE(entries.back().sample->last, last);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const History::Sample& sample = *entries[i].sample;
    ASSERT_EQ(sample.steps, sample.last - sample.first + 1);
    ASSERT_EQ(sample.mean.groups, static_cast<double>(sample.first + sample.last) / 2);
    const std::int64_t before = i > 0 ? entries[i - 1].sample->last : sample.first - 1;
    ASSERT_EQ(sample.first, before + 1);
  }
}

TEST(History, HoldsEachStepOfAShortRun) {
  Recorder run;
  EXPECT_TRUE(run.history.empty());
  EXPECT_TRUE(run.history.between(0, 100).empty());
  run.add(1, 500);
  EXPECT_EQ(run.history.first(), 1);
  EXPECT_EQ(run.history.last(), 500);
  const auto entries = run.history.between(1, 500);
  ASSERT_EQ(entries.size(), 500u);
  expect_covered(entries, 1, 500);
  EXPECT_EQ(entries[6].sample->time, 7 * kDt);
  EXPECT_EQ(entries[6].sample->ta, 7);
  EXPECT_EQ(entries[6].sample->coldest, 7);
  EXPECT_EQ(entries[6].sample->warmest, 8);
  ASSERT_EQ(entries[6].tb.size(), 2u);
  EXPECT_EQ(entries[6].tb[1], 8);
}

TEST(History, APartIsFoundWithItsNeighbours) {
  Recorder run;
  run.add(1, 500);
  const auto entries = run.history.between(100, 110);
  ASSERT_EQ(entries.size(), 13u);
  EXPECT_EQ(entries.front().sample->last, 99);
  EXPECT_EQ(entries.back().sample->last, 111);
}

TEST(History, AStepThatIsThereAlreadyChangesNothing) {
  Recorder run, once;
  run.add(1, 300);
  run.add(100, 350);
  once.add(1, 350);
  const auto entries = run.history.between(1, 350), expected = once.history.between(1, 350);
  ASSERT_EQ(entries.size(), expected.size());
  expect_covered(entries, 1, 350);
}

TEST(History, ALongRunIsCoveredAtEveryScaleWithinBounds) {
  Recorder run;
  constexpr std::int64_t kLast = 300'001;
  run.add(1, kLast);
  for (const std::int64_t steps : {10L, 1000L, 6000L, 30'000L, kLast}) {
    const auto entries = run.history.between(kLast - steps + 1, kLast);
    expect_covered(entries, kLast - steps + 1, kLast);
    EXPECT_GE(entries.size(), std::min<std::size_t>(steps, History::kSamples / History::kMerged));
    EXPECT_LE(entries.size(), History::kSamples + 2u * History::kMerged * History::kLevels);
  }
  const auto finest = run.history.between(1, kLast, kLast);
  expect_covered(finest, 1, kLast);
  EXPECT_EQ(finest.back().sample->steps, 1);
  EXPECT_GT(finest.front().sample->steps, 1);
  // Long ago only coarse samples are left, and still nothing is missing.
  expect_covered(run.history.between(1000, 2000), 1000, 2000);
}

TEST(History, ASampleKeepsTheExtremesAndTheLastTbOfItsSteps) {
  Recorder run;
  run.add(1, 100'000);
  const auto entries = run.history.between(1, 100'000);
  const History::Sample& sample = *entries[10].sample;
  ASSERT_GT(sample.steps, 1);
  const auto groups = static_cast<std::size_t>(Observable::groups);
  EXPECT_EQ(sample.low[groups], static_cast<float>(sample.first));
  EXPECT_EQ(sample.high[groups], static_cast<float>(sample.last));
  EXPECT_EQ(sample.coldest, static_cast<float>(sample.first));
  EXPECT_EQ(sample.warmest, static_cast<float>(sample.last + 1));
  ASSERT_EQ(entries[10].tb.size(), 2u);
  EXPECT_EQ(entries[10].tb[0], static_cast<float>(sample.last));
}

TEST(History, AStepWithoutFlowDoesNotSpoilTheMean) {
  Recorder run;
  run.add(1, 20'000);
  const History::Sample& first = *run.history.between(1, 20'000).front().sample;
  ASSERT_EQ(first.first, 1);
  ASSERT_GT(first.steps, 1);
  EXPECT_TRUE(std::isfinite(first.mean.flow));
  EXPECT_EQ(first.high[static_cast<std::size_t>(Observable::flow)], 1);
}

TEST(History, TruncatedItGoesOnAsIfTheRestHadNotBeen) {
  for (const std::int64_t at : {1L, 63L, 64L, 65L, 777L, 4999L}) {
    Recorder run, straight;
    run.add(1, 5000);
    run.history.truncate(at);
    EXPECT_EQ(run.history.last(), at);
    if (at > 5000 - History::kSamples) expect_covered(run.history.between(1, at), 1, at);
    run.add(at + 1, 9000);
    EXPECT_EQ(run.history.last(), 9000);
    const auto entries = run.history.between(at + 1, 9000);
    EXPECT_GE(entries.back().sample->last, 9000);
    std::map<std::int64_t, int> seen;
    for (const Entry& entry : entries) {
      for (std::int64_t s = entry.sample->first; s <= entry.sample->last; ++s) ++seen[s];
    }
    for (std::int64_t s = at + 1; s <= 9000; ++s) ASSERT_EQ(seen[s], 1) << "step " << s;
  }
}

TEST(History, TruncatedBeforeItsFirstStepItIsEmpty) {
  Recorder run;
  run.add(100, 200);
  run.history.truncate(99);
  EXPECT_TRUE(run.history.empty());
  run.add(50, 60);
  expect_covered(run.history.between(50, 60), 50, 60);
}

TEST(History, ACopyStaysAsItWas) {
  Recorder run;
  run.add(1, 100);
  const History copy = run.history;
  run.history.truncate(70);
  run.add(71, 90);
  Recorder other;
  other.history = copy;
  other.add(101, 150);
  const auto entries = copy.between(1, 100);
  ASSERT_EQ(entries.size(), 100u);
  expect_covered(entries, 1, 100);
  expect_covered(run.history.between(1, 90), 1, 90);
  expect_covered(other.history.between(1, 150), 1, 150);
}

TEST(History, StepsThatWereNotSeenLeaveAGap) {
  Recorder run;
  run.add(1, 10);
  run.add(5001, 20'000);
  const auto entries = run.history.between(1, 20'000);
  std::int64_t steps = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    steps += entries[i].sample->steps;
    const std::int64_t before = i > 0 ? entries[i - 1].sample->last : 0;
    ASSERT_GT(entries[i].sample->first, before);
  }
  EXPECT_EQ(steps, 10 + 15'000);
}

TEST(History, ManyPupsKeepTbOfTheNewestSamplesOnly) {
  constexpr int kPups = 1000;
  ASSERT_TRUE(History::keeps_tb(kPups));
  Recorder run(kPups);
  run.add(1, 3000);
  std::size_t kept = 0;
  for (const Entry& entry : run.history.between(1000, 3000)) kept += entry.tb.size();
  EXPECT_GT(kept, 0u);
  EXPECT_LE(kept * sizeof(float) * History::kLevels, History::kTbBytes);
  EXPECT_FALSE(run.history.between(2999, 3000).back().tb.empty());
}

TEST(History, APupTooManyKeepsNoTb) {
  int most = 1;
  while (History::keeps_tb(most + 1)) ++most;
  EXPECT_GE(most, 1000);
  Recorder run(most + 1);
  run.add(1, 3);
  EXPECT_TRUE(run.history.between(1, 3).back().tb.empty());
  EXPECT_EQ(run.history.between(1, 3).back().sample->warmest, static_cast<float>(3 + most));
}

TEST(History, AnotherLitterStartsAnew) {
  Recorder run(2), other(3);
  run.add(1, 10);
  other.history = run.history;
  other.add(5, 6);
  EXPECT_EQ(other.history.first(), 5);
}

}  // namespace
}  // namespace pupflow::window
