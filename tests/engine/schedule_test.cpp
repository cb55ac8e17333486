// What changes during a run: a schedule does what a caller could do by hand between two steps.
#include "pupflow/schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pupflow/parameters.h"
#include "pupflow/simulation.h"

namespace pupflow {
namespace {

std::size_t place_of(std::string_view name) {
  return static_cast<std::size_t>(find_parameter(name) - parameters().data());
}

Change set_at(std::int64_t step, std::string_view name, double value,
              std::optional<std::int64_t> until = {}) {
  return {
      .step = step, .until = until, .settings = {{place_of(name), value}}, .pup = {}, .action = {}};
}

Change act_at(std::int64_t step, int pup, const Action& action,
              std::optional<std::int64_t> until = {}) {
  return {.step = step, .until = until, .settings = {}, .pup = pup, .action = action};
}

Params small(std::initializer_list<Change> changes) {
  Params params;
  params.pups = 4;
  params.face_points = 3;
  for (const Change& change : changes) params.schedule.add(change);
  return params;
}

Params without_schedule(Params params) {
  params.schedule = {};
  return params;
}

/// T_a with which the step after `steps` is taken.
double ta_after(const Params& params, std::int64_t steps) {
  Params at = params;
  apply_schedule(params, steps, at);
  return at.ambient_temperature;
}

TEST(Schedule, AChangeDoesWhatSettingByHandDoes) {
  const Params params =
      small({set_at(40, "ta", 0.1), set_at(40, "gravity", 5), set_at(60, "dt", 0.005)});
  Simulation scheduled(params), by_hand(without_schedule(params));
  scheduled.run(100);
  by_hand.run(40);
  Params next = by_hand.params();
  next.ambient_temperature = 0.1;
  next.gravity = 5;
  by_hand.set_params(next);
  by_hand.run(20);
  next.dt = 0.005;
  by_hand.set_params(next);
  by_hand.run(40);
  EXPECT_EQ(scheduled.hash(), by_hand.hash());
  EXPECT_EQ(scheduled.time(), by_hand.time());
  EXPECT_EQ(scheduled.params(), by_hand.params());
}

TEST(Schedule, ARampIsLinearInSteps) {
  const Params params = small({set_at(10, "ta", 0.8, 20)});
  EXPECT_EQ(ta_after(params, 9), 0.4);
  EXPECT_EQ(ta_after(params, 10), 0.4);
  EXPECT_DOUBLE_EQ(ta_after(params, 15), 0.6);
  EXPECT_EQ(ta_after(params, 20), 0.8);
  EXPECT_EQ(ta_after(params, 1000), 0.8);
  Simulation ramped(params), by_hand(without_schedule(params));
  for (int step = 0; step < 50; ++step) {
    Params next = by_hand.params();
    next.ambient_temperature = ta_after(params, step);
    by_hand.set_params(next);
    ramped.step();
    by_hand.step();
    ASSERT_EQ(ramped.params().ambient_temperature, next.ambient_temperature) << step;
  }
  EXPECT_EQ(ramped.hash(), by_hand.hash());
}

TEST(Schedule, TheChangeThatBeganLastCounts) {
  const Params params =
      small({set_at(10, "ta", 0.8, 30), set_at(20, "ta", 0.2), set_at(25, "ta", 1, 35),
             set_at(40, "ta", 0), set_at(40, "ta", 0.5)});
  EXPECT_NEAR(ta_after(params, 19), 0.4 + 0.4 * 9 / 20, 1e-15);
  EXPECT_EQ(ta_after(params, 20), 0.2);  // ends the ramp
  EXPECT_EQ(ta_after(params, 25), 0.2);  // a ramp begins where the one before it is
  EXPECT_NEAR(ta_after(params, 30), 0.6, 1e-15);
  EXPECT_EQ(ta_after(params, 40), 0.5);  // at the same step the one added last
}

TEST(Schedule, KnowsWhenSomethingChangesNext) {
  const Params params = small({set_at(10, "ta", 0.1), set_at(20, "ta", 0.2, 23),
                               act_at(30, 1, {.force = {}, .heat = 1, .turn = {}}, 40)});
  const Schedule& schedule = params.schedule;
  EXPECT_EQ(schedule.next_change(0), 10);
  EXPECT_EQ(schedule.next_change(10), 20);
  EXPECT_EQ(schedule.next_change(20), 21);
  EXPECT_EQ(schedule.next_change(22), 23);
  EXPECT_EQ(schedule.next_change(23), 30);
  EXPECT_EQ(schedule.next_change(30), 40);
  EXPECT_EQ(schedule.next_change(40), Schedule::kNever);
  EXPECT_EQ(Schedule().next_change(-1), Schedule::kNever);
}

TEST(Schedule, WhatIsSetByHandBecomesPartOfTheRecipe) {
  Simulation touched(small({set_at(30, "ta", 0.9, 60)}));
  Params next = touched.params();
  next.rigidity = 0.5;
  touched.set_params(next);  // before the first step: a value of the start
  touched.run(40);
  next = touched.params();
  next.ambient_temperature = 0.2;
  touched.set_params(next);
  next.ambient_temperature = 0.3;  // again at the same step: replaces it
  next.drive = 2;
  touched.set_params(next);
  touched.run(30);
  EXPECT_EQ(touched.recipe().rigidity, 0.5);
  EXPECT_EQ(touched.recipe().schedule.changes().size(), 3u);
  EXPECT_EQ(touched.params().ambient_temperature, 0.3);
  EXPECT_FALSE(touched.edited());
  Simulation again(touched.recipe());
  again.run(70);
  EXPECT_EQ(again.hash(), touched.hash());
}

TEST(Schedule, ASnapshotGoesOnInTheMiddleOfIt) {
  const Params params = small({set_at(10, "ta", 0.9, 50), set_at(20, "dt", 0.008),
                               act_at(15, 2, {.force = {3, 0, 0}, .heat = 0, .turn = 1}, 45)});
  for (const std::int64_t at : {10, 20, 30, 50}) {
    Simulation whole(params);
    whole.run(at);
    const Snapshot snapshot = whole.snapshot();
    EXPECT_EQ(snapshot.view().time, whole.time());
    Simulation rest(snapshot);
    EXPECT_EQ(rest.params(), whole.params()) << at;
    whole.run(60 - at);
    rest.run(60 - at);
    EXPECT_EQ(rest.hash(), whole.hash()) << at;
    EXPECT_EQ(rest.time(), whole.time()) << at;
    EXPECT_EQ(rest.recipe(), params);
  }
}

TEST(Schedule, ForcesAccelerate) {
  Params params = small({act_at(2, 0, {.force = {1, -2, 4}, .heat = 0, .turn = {}}, 5),
                         act_at(3, 0, {.force = {1, 0, 0}, .heat = 0, .turn = {}}, 4)});
  params.gravity = params.drive = 0;
  Simulation simulation(params);
  simulation.run(8);
  const LitterView litter = simulation.view();
  EXPECT_NEAR(litter.velocities.mean(0).x(), 4 * params.dt, 1e-12);  // both in step 4
  EXPECT_NEAR(litter.velocities.mean(0).y(), -6 * params.dt, 1e-12);
  EXPECT_NEAR(litter.velocities.mean(0).z(), 12 * params.dt, 1e-12);
  EXPECT_NEAR(litter.velocities.mean(1).norm(), 0, 1e-12);
}

TEST(Schedule, HeatAddsToThermogenesis) {
  Params params = small({act_at(5, 1, {.force = {}, .heat = 0.2, .turn = {}}, 9)});
  params.air_conductance = params.contact_conductance = params.thermogenesis = 0;
  Simulation simulation(params);
  simulation.run(12);
  EXPECT_EQ(simulation.view().tb[0], params.initial_temperature);
  EXPECT_NEAR(simulation.view().tb[1], params.initial_temperature + 4 * params.dt * 0.2, 1e-15);
}

TEST(Schedule, ATurnReplacesThePupsOwn) {
  for (const double drive : {0.0, 1.0}) {
    Params params = small({act_at(3, 0, {.force = {}, .heat = 0, .turn = 0.5}, 13)});
    params.pups = 1;
    params.drive = drive;
    Simulation simulation(params);
    const double before = simulation.view().heading[0];
    simulation.run(20);
    const double turned =
        std::remainder(simulation.view().heading[0] - before, 2 * std::numbers::pi);
    EXPECT_NEAR(turned, 10 * params.dt * 0.5, 1e-12) << drive;
  }
}

TEST(Schedule, ActionsByHandDoWhatScheduledOnesDo) {
  const Action action{.force = {2, 0, 1}, .heat = 0.1, .turn = -0.5};
  Simulation scheduled(small({act_at(20, 3, action, 50)}));
  Simulation by_hand(small({}));
  scheduled.run(80);
  by_hand.run(20);
  by_hand.set_action(3, action);
  EXPECT_EQ(by_hand.action(3), action);
  EXPECT_EQ(by_hand.edited(), 20);
  by_hand.run(10);
  Simulation copy(by_hand.snapshot());  // keeps the action
  EXPECT_EQ(copy.edited(), 20);
  for (Simulation* simulation : {&by_hand, &copy}) {
    simulation->run(20);
    simulation->set_action(3, {});
    simulation->run(30);
    EXPECT_EQ(simulation->hash(), scheduled.hash());
  }
  EXPECT_FALSE(scheduled.edited());
}

TEST(Schedule, MayBeReplacedFromHereOn) {
  Simulation simulation(small({set_at(10, "ta", 0.1), set_at(30, "ta", 0.9)}));
  simulation.run(20);
  Schedule later;
  later.add(set_at(5, "ta", 0.7));  // past: not taken
  later.add(set_at(25, "ta", 0.3));
  simulation.set_schedule(later);
  const Params expected = small({set_at(10, "ta", 0.1), set_at(25, "ta", 0.3)});
  EXPECT_EQ(simulation.recipe(), expected);
  simulation.run(20);
  Simulation again(expected);
  again.run(40);
  EXPECT_EQ(again.hash(), simulation.hash());
}

TEST(Schedule, NothingScheduledNeedsNothing) {
  Params params = small({act_at(50, 0, {.force = {}, .heat = 0.1, .turn = 0.5}, 60)});
  params.air_conductance = params.contact_conductance = params.thermogenesis = params.drive = 0;
  Simulation simulation(params);
  const auto heats = [&] { return simulation.plan().has(Stage::heat); };
  const auto steers = [&] { return simulation.plan().has(Stage::steering); };
  simulation.run(50);
  EXPECT_FALSE(heats() || steers());
  simulation.run(1);
  EXPECT_TRUE(heats() && steers());
  simulation.run(10);
  EXPECT_FALSE(heats() || steers());
}

TEST(Schedule, NoWarningWhileSomebodyPushes) {
  Params params = small({act_at(0, 0, {.force = {0, 0, 40}, .heat = 0, .turn = {}}, 300)});
  params.pups = 1;
  Simulation simulation(params);
  simulation.run(300);
  EXPECT_GT(simulation.view().positions.mean(0).z(), 50);
  EXPECT_TRUE(simulation.warnings().empty());
}

TEST(Schedule, OnlyWhatIsToComeIsCheckedFromAStepOn) {
  // Sound before step 20, not together at step 30.
  const Params p =
      small({set_at(10, "refinement", 1), set_at(20, "refinement", 0), set_at(25, "dt", 0.1, 30)});
  EXPECT_TRUE(check(p).empty());
  const Params wrong = small({set_at(10, "refinement", 1), set_at(20, "dt", 0.1, 30)});
  for (const std::int64_t from : {0, 10, 11, 21, 30}) EXPECT_EQ(check(wrong, from).size(), 1u);
  EXPECT_TRUE(check(wrong, 31).empty());
  Simulation litter(small({set_at(40, "dt", 0.1)}));
  litter.run(5);
  Params next = litter.params();
  next.refinement = Refinement::consistent;  // goes with dt = 0.01, not with what comes at step 40
  EXPECT_THROW(litter.set_params(next), InvalidParams);
}

TEST(Schedule, EverythingWrongIsSaidAtOnce) {
  const auto messages = [](std::initializer_list<Change> changes) {
    std::string text;
    for (const Problem& problem : check(small(changes))) text += problem.message + '\n';
    return text;
  };
  using testing::HasSubstr;
  const std::string all =
      messages({set_at(-1, "ta", 0.1), set_at(5, "ta", 0.1, 5), set_at(6, "alpha", 2),
                set_at(7, "pups", 3), set_at(8, "contact", 1, 9),
                act_at(10, 4, {.force = {1, 0, 0}, .heat = 0, .turn = {}}), act_at(11, 0, {})});
  EXPECT_THAT(all, HasSubstr("at step -1: step must be a whole number 0 … 2^53 - 1\n"));
  EXPECT_THAT(all, HasSubstr("at step 5: until = 5 must be after it\n"));
  EXPECT_THAT(all, HasSubstr("at step 6: alpha = 2: rigidity must be 0 … 1\n"));
  EXPECT_THAT(all, HasSubstr("at step 7: pups can only be set for the whole run\n"));
  EXPECT_THAT(
      all, HasSubstr("at step 8: contact changes at once and has no values between: no until\n"));
  EXPECT_THAT(all, HasSubstr("at step 10: there is no pup 4 among 4\n"));
  EXPECT_THAT(all, HasSubstr("at step 11: nothing is done to the pup; name force, heat or turn\n"));
  EXPECT_THAT(messages({act_at(3, 0, {.force = {NAN, 0, 0}, .heat = INFINITY, .turn = NAN})}),
              testing::AllOf(HasSubstr("force must be"), HasSubstr("heat must be"),
                             HasSubstr("turn must be")));
  for (const std::size_t beyond : {parameters().size(), std::size_t{9999}, SIZE_MAX}) {
    Params p = small({});
    p.schedule.set(5, beyond, 1);
    ASSERT_EQ(check(p).size(), 1u);
    EXPECT_EQ(check(p)[0].message,
              "at step 5: there is no parameter number " + std::to_string(beyond));
  }
  EXPECT_EQ(messages({set_at(0, "ta", 0.1), set_at(5, "ta", 0.9, 50)}), "");
  // Allowed each by itself, not together.
  EXPECT_THAT(messages({set_at(10, "refinement", 1), set_at(20, "dt", 0.1, 30)}),
              HasSubstr("at step 30: refinement = consistent: dt = 0.1 must be at most 0.01"));
  EXPECT_THROW(Simulation(small({set_at(6, "alpha", 2)})), InvalidParams);
}

}  // namespace
}  // namespace pupflow
