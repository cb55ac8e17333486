// Going back in a run, and its other future.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <random>

#include "tests/window/session_words.h"

namespace pupflow::window {
namespace {

constexpr int kEventfulSteps = 620;

/// Plays a run in which everything is done that can be. Returns the states on the way.
std::map<std::int64_t, LiveState> play_eventful(Session& session) {
  std::map<std::int64_t, LiveState> seen;
  for (int step = 0; step < kEventfulSteps; ++step) {
    if (step == 40) set(session, "ta", 0.1);
    if (step == 150) have(session, RampTo{place("ta"), 0.7, 100, true});
    if (step == 200) set(session, "dt", 0.005);
    if (step == 333) have(session, Pull{1, {0.5, -0.5, 0.4}});
    if (step == 420) have(session, Pull{});
    if (step == 500) set(session, "beta", 0.2);
    seen[step] = look_at(session);
    session.step();
  }
  seen[kEventfulSteps] = look_at(session);
  return seen;
}

void expect_same(const LiveState& there, const LiveState& first) {
  EXPECT_EQ(there.view().step, first.view().step);
  EXPECT_EQ(there.hash, first.hash);
  EXPECT_EQ(there.view().time, first.view().time);
  EXPECT_EQ(there.view().params, first.view().params);
  EXPECT_EQ(there.warnings.size(), first.warnings.size());
  ASSERT_EQ(there.observables.has_value(), first.observables.has_value());
  for (const ObservableField& field : observables()) {
    if (!there.observables) break;
    const double a = (*there.observables).*field.value, b = (*first.observables).*field.value;
    EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << field.name << ' ' << a << ' ' << b;
  }
}

TEST(Timeline, EveryStepCanBeGoneBackTo) {
  Session session(small_litter(), true);
  const auto seen = play_eventful(session);
  const LiveState end = look_at(session);
  std::mt19937 random(7);
  for (int jump = 0; jump < 200; ++jump) {
    const auto step = static_cast<std::int64_t>(random() % (kEventfulSteps + 1));
    have(session, GoTo{step});
    const LiveState there = look_at(session);
    SCOPED_TRACE(step);
    expect_same(there, seen.at(step));
    ASSERT_EQ(there.view().recipe, end.view().recipe);
    ASSERT_EQ(there.timeline.last, kEventfulSteps);
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

TEST(Timeline, WithALongFlowLagToo) {
  Params params = small_litter();
  params.flow_lag = 130;
  Session session(params, true);
  const auto seen = play_eventful(session);
  for (const std::int64_t step : {400, 129, 130, 131, 0, 620, 250}) {
    have(session, GoTo{step});
    SCOPED_TRACE(step);
    expect_same(look_at(session), seen.at(step));
  }
}

TEST(Timeline, PlayingOnFromAnEarlierStepIsTheSameRunAgain) {
  Session session(small_litter(), true);
  const auto seen = play_eventful(session);
  const LiveState end = look_at(session);
  have(session, GoTo{123});
  session.apply(PlayPause{});
  for (std::int64_t step = 124; step <= kEventfulSteps; ++step) {
    session.step();
    ASSERT_EQ(look_at(session).hash, seen.at(step).hash) << step;
  }
  EXPECT_EQ(look_at(session).history.between(0, 620).size(), end.history.between(0, 620).size());
  play(session, 100);
  const LiveState later = look_at(session);
  EXPECT_EQ(later.timeline.last, kEventfulSteps + 100);
  EXPECT_FALSE(later.timeline.parted_at);
  EXPECT_EQ(later.hash, headless(later));
}

TEST(Timeline, TheRecipeRepeatsWhatWasSeen) {
  Session session(small_litter(), true);
  play_eventful(session);
  EXPECT_EQ(look_at(session).hash, headless(look_at(session)));
  have(session, GoTo{300});
  EXPECT_EQ(look_at(session).hash, headless(look_at(session)));
  set(session, "gravity", 4);  // another future
  have(session, RampTo{place("tp"), 0.5, 50, false});
  have(session, Pull{0, {1, 0, 0.3}});
  play(session, 200);
  have(session, Undo{});
  play(session, 50);
  EXPECT_EQ(look_at(session).hash, headless(look_at(session)));
  have(session, SwapFuture{});
  EXPECT_EQ(look_at(session).view().step, kEventfulSteps);
  EXPECT_EQ(look_at(session).hash, headless(look_at(session)));
}

TEST(Timeline, AnEditInThePastBeginsAnotherFuture) {
  Session session(small_litter(), true);
  set(session, "alpha", 0.6);
  play(session, 150);
  set(session, "ta", 0.1);
  play(session, 150);
  const LiveState old = look_at(session);

  have(session, GoTo{100});
  set(session, "gravity", 3);
  const LiveState parted = look_at(session);
  EXPECT_EQ(parted.timeline.last, 100);
  EXPECT_EQ(parted.timeline.parted_at, 100);
  EXPECT_EQ(parted.timeline.other_last, 300);
  EXPECT_EQ(parted.history.last(), 100);
  play(session, 80);
  const LiveState branch = look_at(session);
  EXPECT_EQ(branch.view().params.ambient_temperature, 0.4) << "later edits are of the old future";
  EXPECT_EQ(branch.view().params.rigidity, 0.6);
  ASSERT_EQ(branch.timeline.marks.size(), 2u);

  have(session, SwapFuture{});
  expect_same(look_at(session), old);
  EXPECT_EQ(look_at(session).timeline.parted_at, 100);
  EXPECT_EQ(look_at(session).timeline.other_last, 180);
  EXPECT_EQ(look_at(session).history.last(), 300);
  have(session, SwapFuture{});
  expect_same(look_at(session), branch);
}

TEST(Timeline, TheScheduleOfTheSceneStaysInEveryFuture) {
  Params params = small_litter();
  params.schedule.add(
      {.step = 120, .until = 200, .settings = {{place("ta"), 0.8}}, .pup = {}, .action = {}});
  Session session(params, true);
  play(session, 150);
  have(session, GoTo{50});
  set(session, "ta", 0.3);
  play(session, 200);
  EXPECT_EQ(value(session, "ta"), 0.8);
  EXPECT_EQ(look_at(session).hash, headless(look_at(session)));
}

TEST(Timeline, ARestartKeepsTheOldRunAsTheOtherFuture) {
  Session session(small_litter(), true);
  set(session, "ta", 0.2);
  play(session, 130);
  const LiveState old = look_at(session);
  have(session, Restart{});
  EXPECT_EQ(look_at(session).timeline.last, 0);
  EXPECT_EQ(look_at(session).timeline.parted_at, 0);
  EXPECT_TRUE(look_at(session).history.empty());
  play(session, 20);
  set(session, "pups", 5);
  EXPECT_EQ(look_at(session).view().pups, 5);
  EXPECT_EQ(look_at(session).timeline.other_last, 20);
  have(session, Restart{});
  play(session, 10);
  have(session, SwapFuture{});
  have(session, SwapFuture{});
  EXPECT_EQ(look_at(session).view().step, 10);
}

TEST(Timeline, ManyFuturesFitIntoMemory) {
  Keyframes frames;
  Simulation simulation(small_litter());
  for (int step = 1; step <= 6000; ++step) {
    simulation.step();
    if (frames.wants(step)) frames.add(simulation);
    frames.keep_within(80'000);
  }
  EXPECT_LE(frames.bytes(), 80'000u);
  ASSERT_GE(frames.size(), 3u);
  EXPECT_EQ(frames.at_or_before(99), nullptr);
  std::int64_t longest = 0, before = 0;
  for (std::int64_t step = 0; step <= 6000; ++step) {
    const auto frame = frames.at_or_before(step);
    if (frame && frame->step != before) {
      longest = std::max(longest, frame->step - before);
      before = frame->step;
    }
  }
  EXPECT_LE(longest, 2 * 6000 / static_cast<std::int64_t>(frames.size())) << "evenly";
  EXPECT_NEAR(static_cast<double>(frames.bytes() / frames.size()),
              static_cast<double>(Keyframes::needed_for(simulation)), 1500);
  frames.keep_within(10);
  EXPECT_EQ(frames.size(), 0u);
}

TEST(Timeline, WhatIsAskedForOnTheWayWaitsForTheArrival) {
  Session session(small_litter(), true);
  play(session, 300);
  session.apply(GoTo{90});
  session.apply(Advance{2});
  session.apply(GoTo{200});  // after those steps
  EXPECT_FALSE(session.changed());
  EXPECT_TRUE(session.hurried());
  while (session.hurried()) session.step();
  EXPECT_EQ(look_at(session).view().step, 200);
  session.apply(GoTo{90});
  set(session, "ta", 0.1);
  EXPECT_EQ(look_at(session).timeline.parted_at, 90);
  have(session, GoTo{-5});
  EXPECT_EQ(look_at(session).view().step, 0);
  have(session, GoTo{5000});
  EXPECT_EQ(look_at(session).view().step, 90);
}

TEST(Timeline, GoesBackFromABadState) {
  Session session(runaway(), true);
  while (session.running()) session.step();
  const LiveState bad = look_at(session);
  ASSERT_FALSE(bad.status.ok());
  const std::int64_t last = bad.timeline.last;
  ASSERT_GT(last, 2);
  ASSERT_FALSE(bad.timeline.marks.empty());
  EXPECT_EQ(bad.timeline.marks.back().kind, Timeline::Kind::bad);
  have(session, GoTo{last});
  EXPECT_TRUE(look_at(session).status.ok());
  play(session, 1);
  EXPECT_FALSE(look_at(session).status.ok());
  set(session, "ta", 0.6);  // at the last good step
  EXPECT_TRUE(look_at(session).status.ok());
  EXPECT_EQ(look_at(session).view().step, last);
  EXPECT_EQ(look_at(session).view().params.ambient_temperature, 0.6);
  have(session, GoTo{1});
  set(session, "k1", 0.9);
  session.apply(PlayPause{});
  play(session, 300);
  EXPECT_TRUE(look_at(session).status.ok());
}

}  // namespace
}  // namespace pupflow::window
