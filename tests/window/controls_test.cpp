#include "app/window/controls.h"

#include <gmock/gmock.h>

#include <cmath>

namespace pupflow::window {
namespace {

TEST(Controls, ASoundProposalIsSentWhole) {
  Controls controls;
  Params edited;
  edited.ambient_temperature = 0.2;
  controls.propose(edited);
  ASSERT_EQ(controls.commands.size(), 1u);
  EXPECT_EQ(std::get<Edit>(controls.commands[0]).params, edited);
  EXPECT_EQ(controls.params, edited);
}

TEST(Controls, AnUnsoundProposalIsRefusedWithItsReason) {
  Controls controls;
  Params edited;
  edited.arena_radius = 0.2;  // fine on its own, too small for a pup
  controls.propose(edited);
  EXPECT_TRUE(controls.commands.empty());
  EXPECT_EQ(controls.params, Params{});
  EXPECT_THAT(controls.problem, testing::HasSubstr("arena_radius"));
  controls.propose(Params{});
  EXPECT_EQ(controls.problem, "");
  EXPECT_TRUE(controls.commands.empty()) << "nothing changed";
}

double asked_speed(const Controls& controls) {
  return std::get<Speed>(controls.commands.back()).factor;
}

TEST(Controls, ASpeedIsTakenAsItIsAndTheKeysStayOnTheSlider) {
  Controls controls;
  controls.set_speed(1000);
  EXPECT_EQ(asked_speed(controls), 1000);
  controls.faster();
  EXPECT_EQ(asked_speed(controls), 1000) << "a key does not slow down either";
  controls.slower();
  EXPECT_EQ(asked_speed(controls), 500);
  controls.set_speed(48);
  controls.faster();
  EXPECT_EQ(asked_speed(controls), Controls::kFastest);
  controls.set_speed(0.1);
  controls.slower();
  EXPECT_EQ(asked_speed(controls), Controls::kSlowest);
}

TEST(Controls, BelowAsFastAsPossibleComesTheSpeedBefore) {
  Controls controls;
  controls.set_speed(4);
  controls.set_as_fast(true);
  EXPECT_TRUE(std::isinf(asked_speed(controls)));
  controls.slower();
  EXPECT_EQ(asked_speed(controls), 4);
  EXPECT_FALSE(controls.as_fast);
}

TEST(Controls, OneParameterIsCheckedInItsOwnRangeFirst) {
  Controls controls;
  controls.propose(*find_parameter("alpha"), 7);
  EXPECT_TRUE(controls.commands.empty());
  EXPECT_EQ(controls.problem_at, "alpha");
  controls.propose(*find_parameter("alpha"), 0.5);
  EXPECT_EQ(std::get<Edit>(controls.commands.back()).params.rigidity, 0.5);
  EXPECT_EQ(controls.problem_at, "");
}

TEST(Controls, FollowsWhatTheRunHasChangedAndNothingElse) {
  Controls controls;
  controls.propose(*find_parameter("pups"), 20);  // on its way
  LiveState state;
  Params params;
  params.ambient_temperature = 0.2;  // by a ramp, undo, going back
  state.litter.take(Simulation(params), false);
  controls.follow(state);
  EXPECT_EQ(controls.params.ambient_temperature, 0.2);
  EXPECT_EQ(controls.params.pups, 20);
}

TEST(Controls, GoesToStepsOfTheRunOnlyAndRemembersWhichUntilItIsShown) {
  Controls controls;
  LiveState state;
  state.timeline.last = 500;
  controls.go_to(900, state.timeline);
  EXPECT_EQ(std::get<GoTo>(controls.commands.back()).step, 500);
  EXPECT_EQ(controls.shown_step(state), 500);
  controls.go_to(controls.shown_step(state) - 1, state.timeline);
  EXPECT_EQ(std::get<GoTo>(controls.commands.back()).step, 499) << "from where it is going";
  controls.follow(state);
  EXPECT_EQ(controls.shown_step(state), 499) << "not there yet";
  controls.commands.push_back(Advance{1});
  state.gone_to = 1;
  controls.follow(state);
  EXPECT_EQ(controls.shown_step(state), 499) << "that was the first one";
  state.gone_to = 2;
  Simulation simulation(Params{});
  simulation.run(2);
  state.litter.take(simulation, false);
  controls.follow(state);
  EXPECT_EQ(controls.shown_step(state), 2) << "it was there and has gone on since";
}

TEST(Controls, ARefusedEditIsTakenBackOnceAndLaterOnesStay) {
  Controls controls;
  LiveState state;
  state.litter.take(Simulation(Params{}), false);
  controls.propose(*find_parameter("pups"), 20);
  state.refusals = 1;
  state.rejected = "no room";
  controls.follow(state);
  EXPECT_EQ(controls.params, Params{});
  controls.propose(*find_parameter("alpha"), 0.5);  // on its way
  controls.follow(state);
  EXPECT_EQ(controls.params.rigidity, 0.5);
}

TEST(Controls, AnotherFieldHasTheScaleOfItsKind) {
  Controls controls;
  controls.look.scale.set_map("inferno");
  controls.look.scale.set_range(0.2, 0.4);
  controls.color_by(*find_field("turn"));
  EXPECT_EQ(controls.look.scale.field->name, "turn");
  EXPECT_EQ(controls.look.scale.map_name, "bluered");
  EXPECT_EQ(controls.look.scale.ends, view::Ends::automatic);
  ASSERT_EQ(controls.commands.size(), 1u);
  const auto* command = std::get_if<ColorBy>(&controls.commands.front());
  ASSERT_NE(command, nullptr);
  EXPECT_EQ(command->field->name, "turn");
}

}  // namespace
}  // namespace pupflow::window
