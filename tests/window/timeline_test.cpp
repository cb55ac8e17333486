// Going back in a run, its other future, and what can be done in it.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <random>

#include "app/window/session/pull.h"
#include "app/window/session/session.h"

namespace pupflow::window {
namespace {

using testing::HasSubstr;

Params small_litter() {
  Params params;
  params.pups = 3;
  params.face_points = 3;
  params.seed = 11;
  return params;
}

/// Heat by forward Euler far outside its region: the status turns bad within some steps.
Params runaway() {
  Params params;
  params.pups = 2;
  params.heat = HeatRule::euler;
  params.air_conductance = 500;
  return params;
}

std::size_t place(std::string_view name) {
  return static_cast<std::size_t>(find_parameter(name) - parameters().data());
}

LiveState look_at(Session& session) {
  LiveState state;
  session.fill(state, true);
  return state;
}

void play(Session& session, int steps) {
  for (int i = 0; i < steps; ++i) session.step();
}

/// Has the command carried out, and the litter go where it sends it.
void have(Session& session, const Command& command) {
  session.apply(command);
  while (session.hurried()) session.step();
}

void set(Session& session, std::string_view name, double value, bool continues = false) {
  const Params before = session.params();
  Params params = before;
  find_parameter(name)->set(params, value);
  have(session, Edit{params, before, continues});
}

double value(Session& session, std::string_view name) {
  return find_parameter(name)->get(session.params());
}

/// What the recipe comes to without any window.
std::uint64_t headless(const LiveState& state) {
  Simulation again(state.view().recipe);
  again.run(state.view().step);
  EXPECT_FALSE(again.edited());
  return again.hash();
}

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

TEST(Timeline, ARampThereAndBack) {
  Session session(small_litter(), true);
  play(session, 10);
  have(session, RampTo{place("ta"), 0.8, 40, true});
  const LiveState begun = look_at(session);
  ASSERT_EQ(begun.timeline.marks.size(), 1u);
  EXPECT_EQ(begun.timeline.marks[0].step, 10);
  EXPECT_EQ(begun.timeline.marks[0].until, 90);
  EXPECT_EQ(begun.timeline.marks[0].text, "T_a 0.4 \u2192 0.8 and back");
  play(session, 41);
  EXPECT_DOUBLE_EQ(value(session, "ta"), 0.8);
  play(session, 40);
  EXPECT_DOUBLE_EQ(value(session, "ta"), 0.4);
  EXPECT_EQ(look_at(session).hash, headless(look_at(session)));
}

TEST(Timeline, SaysWhyARampCannotBe) {
  Session session(small_litter(), true);
  const auto rejected = [&](const RampTo& ramp) {
    have(session, ramp);
    return look_at(session).rejected;
  };
  EXPECT_THAT(rejected({place("pups"), 20, 10}), HasSubstr("pups cannot"));
  EXPECT_THAT(rejected({place("contact"), 1, 10}), HasSubstr("contact has no values between"));
  EXPECT_THAT(rejected({place("alpha"), 2, 10}), HasSubstr("alpha"));
  EXPECT_THAT(rejected({place("ta"), std::nan(""), 10}), HasSubstr("ta"));
  EXPECT_THAT(rejected({place("ta"), 0.2, 0}), HasSubstr("step"));
  EXPECT_THAT(rejected({9999, 0.2, 10}), HasSubstr("no such"));
  EXPECT_TRUE(look_at(session).view().recipe.schedule.empty());
  EXPECT_EQ(rejected({place("ta"), 0.2, 10}), "");
}

TEST(Timeline, UndoTakesBackEditsAndRedoMakesThemAgain) {
  Session session(small_litter(), true);
  play(session, 5);
  set(session, "ta", 0.1);
  play(session, 5);
  set(session, "gravity", 2);
  play(session, 5);
  have(session, Undo{});
  EXPECT_EQ(value(session, "gravity"), 10);
  play(session, 5);
  have(session, Undo{});
  EXPECT_EQ(value(session, "ta"), 0.4);
  EXPECT_FALSE(look_at(session).timeline.can_undo);
  have(session, Undo{});
  have(session, Redo{});
  have(session, Redo{});
  EXPECT_FALSE(look_at(session).timeline.can_redo);
  EXPECT_EQ(value(session, "ta"), 0.1);
  EXPECT_EQ(value(session, "gravity"), 2);
  play(session, 5);
  EXPECT_EQ(look_at(session).hash, headless(look_at(session)));
  set(session, "ta", 0.3);
  have(session, Undo{});
  set(session, "ta", 0.2);
  EXPECT_FALSE(look_at(session).timeline.can_redo) << "what was undone is gone";
}

TEST(Timeline, AnEditThatIsUndoneAtOnceLeavesNoTrace) {
  Session session(small_litter(), true);
  play(session, 5);
  const LiveState before = look_at(session);
  set(session, "ta", 0.1);
  have(session, RampTo{place("ta"), 0.9, 30});
  have(session, Undo{});
  have(session, Undo{});
  EXPECT_EQ(look_at(session).view().recipe, before.view().recipe);
  EXPECT_EQ(look_at(session).view().params, before.view().params);
  EXPECT_TRUE(look_at(session).timeline.marks.empty());
}

TEST(Timeline, UndoneARampEnds) {
  Session session(small_litter(), true);
  play(session, 10);
  have(session, RampTo{place("ta"), 0.8, 40, true});
  play(session, 20);
  EXPECT_GT(value(session, "ta"), 0.5);
  have(session, Undo{});
  EXPECT_EQ(value(session, "ta"), 0.4);
  EXPECT_EQ(look_at(session).timeline.marks[0].until, 30);
  play(session, 100);
  EXPECT_EQ(value(session, "ta"), 0.4);
  EXPECT_EQ(look_at(session).hash, headless(look_at(session)));
  have(session, Redo{});
  play(session, 41);
  EXPECT_DOUBLE_EQ(value(session, "ta"), 0.8);
}

TEST(Timeline, AnEditEndsARampOfTheSameParameter) {
  Session session(small_litter(), true);
  have(session, RampTo{place("ta"), 0.8, 40, true});
  play(session, 20);
  set(session, "ta", 0.3);
  play(session, 100);
  EXPECT_EQ(value(session, "ta"), 0.3);
}

TEST(Timeline, OneDragIsOneEntry) {
  Session session(small_litter(), true);
  set(session, "ta", 0.3);
  for (int i = 1; i <= 5; ++i) {
    set(session, "gravity", 10 - i, i > 1);
    play(session, 3);
  }
  const LiveState dragged = look_at(session);
  ASSERT_EQ(dragged.timeline.marks.size(), 2u);
  EXPECT_EQ(dragged.timeline.marks[1].text, "g 10 \u2192 5");
  have(session, Undo{});
  EXPECT_EQ(value(session, "gravity"), 10);
  EXPECT_EQ(value(session, "ta"), 0.3);
}

TEST(Timeline, UndoOfARestartRestartsBack) {
  Session session(small_litter(), true);
  play(session, 20);
  set(session, "pups", 5);
  play(session, 20);
  have(session, Undo{});
  EXPECT_EQ(look_at(session).view().pups, 3);
  EXPECT_EQ(look_at(session).view().step, 0);
  have(session, Redo{});
  EXPECT_EQ(look_at(session).view().pups, 5);
}

TEST(Timeline, UndoOfARestartGoesBackToTheCheckpoint) {
  Simulation start(small_litter());
  start.run(130);
  Session session(start.recipe(), true, 1, start.snapshot());
  play(session, 150);
  const LiveState then = look_at(session);
  have(session, GoTo{135});
  EXPECT_EQ(look_at(session).timeline.first, 130);
  set(session, "pups", 5);
  EXPECT_EQ(look_at(session).view().step, 0);
  have(session, Undo{});
  play(session, 150);
  EXPECT_EQ(look_at(session).hash, then.hash);
}

/// One command of any kind, with numbers that make sense, mostly.
Command any_command(std::mt19937& random, const Params& params, std::int64_t last) {
  const auto below = [&](std::int64_t n) { return static_cast<std::int64_t>(random() % n); };
  const auto share = [&] { return static_cast<double>(random() % 1001) / 1000; };
  const char* const names[] = {"ta", "tp", "alpha", "beta", "gravity", "drive", "k1", "dt"};
  const auto any_name = [&] { return names[below(std::size(names))]; };
  const auto changed = [&](std::string_view name, double value) {
    Params next = params;
    find_parameter(name)->set(next, value);
    return next;
  };
  switch (below(16)) {
    case 0:
    case 1:
      return GoTo{below(last + 1)};
    case 2:
    case 3:
      return Edit{changed(any_name(), share()), params, below(2) == 0};
    case 4:
      return Edit{changed("dt", 0.002 + 0.01 * share()), params};
    case 5:
      return below(4) == 0 ? Edit{changed("pups", 2.0 + static_cast<double>(below(3))), params}
                           : Edit{changed("heading", static_cast<double>(below(2))), params};
    case 6:
      return RampTo{place(any_name()), share(), 1 + below(80), below(2) == 0};
    case 7:
    case 8:
      return below(3) == 0 ? Pull{} : Pull{static_cast<int>(below(4)), {share(), -share(), 0.4}};
    case 9:
      return SwapFuture{};
    case 10:
    case 11:
      return Undo{};
    case 12:
      return Redo{};
    case 13:
      return below(3) == 0 ? Command{Restart{}} : Command{Advance{below(30)}};
    case 14:
      return below(2) == 0 ? Compare{} : Compare{changed(any_name(), 0.1 + share()), below(2) == 0};
    default:
      return below(2) == 0 ? Command{Observe{below(4) > 0}}
                           : Command{Watch{.parts = {Part::strain, Part::sides}}};
  }
}

TEST(Timeline, WhateverIsDoneTheRecipeRepeatsWhatIsSeen) {
  Params params = small_litter();
  params.schedule.add(
      {.step = 100, .until = 160, .settings = {{place("ta"), 0.8}}, .pup = {}, .action = {}});
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    Session session(params, true);
    for (int i = 0; i < 120; ++i) {
      const LiveState before = look_at(session);
      have(session, any_command(random, session.params(), before.timeline.last));
      const bool good = look_at(session).status.ok();
      for (auto steps = random() % 40; steps > 0 && good; --steps) session.step();
      const LiveState state = look_at(session);
      ASSERT_LE(state.view().step, state.timeline.last);
      ASSERT_LE(state.history.last(), state.timeline.last);
      for (const Timeline::Mark& mark : state.timeline.marks) {
        ASSERT_LE(mark.step, state.timeline.last) << mark.text;
      }
      if (!state.status.ok()) {
        have(session, GoTo{state.timeline.last / 2});
        continue;
      }
      ASSERT_EQ(state.hash, headless(state)) << "seed " << seed << ", command " << i;
      if (!state.second || !state.second->status.ok()) continue;
      ASSERT_EQ(state.second->view().step, state.view().step);
      Simulation second(state.second->view().recipe);
      second.run(state.second->view().step);
      const LitterView expected = second.view();
      ASSERT_TRUE(
          std::equal(expected.tb.begin(), expected.tb.end(), state.second->view().tb.begin()))
          << "seed " << seed << ", command " << i;
    }
  }
}

}  // namespace
}  // namespace pupflow::window
