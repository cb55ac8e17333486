#include "app/window/session/session.h"

#include <gmock/gmock.h>

#include "tests/window/session_words.h"

namespace pupflow::window {
namespace {

void step_until_bad(Session& session) {
  for (int i = 0; i < 5000 && session.running(); ++i) session.step();
}

TEST(Session, AnEditActsOnTheNextStep) {
  Params edited = small_litter();
  edited.gravity = 3;
  edited.ambient_temperature = 0.1;
  Simulation expected(small_litter());
  expected.run(5);
  expected.set_params(edited);
  expected.run(1);

  Session session(small_litter(), true);
  for (int i = 0; i < 5; ++i) session.step();
  session.apply(Edit{edited});
  session.step();
  const LiveState snapshot = look_at(session);
  EXPECT_EQ(snapshot.hash, expected.hash());
  EXPECT_EQ(snapshot.view().params, edited);
  EXPECT_EQ(snapshot.view().step, 6);
  EXPECT_EQ(snapshot.view().recipe, expected.recipe());
}

/// A litter whose T_a rises from 0.4 to 0.8 between steps 2 and 10.
Params warming_litter() {
  const auto ta = static_cast<std::size_t>(find_parameter("ta") - parameters().data());
  Params params = small_litter();
  params.schedule.add({.step = 2, .until = 10, .settings = {{ta, 0.8}}, .pup = {}, .action = {}});
  return params;
}

TEST(Session, TheScheduleGoesOnBesideAnEdit) {
  const Params params = warming_litter();
  Session session(params, true);
  for (int i = 0; i < 5; ++i) session.step();
  Params edited = small_litter();  // as the window still sees T_a
  edited.gravity = 3;
  session.apply(Edit{edited, small_litter()});
  for (int i = 0; i < 10; ++i) session.step();
  const LiveState later = look_at(session);
  EXPECT_EQ(later.view().params.gravity, 3);
  EXPECT_EQ(later.view().params.ambient_temperature, 0.8);
  Simulation again(later.view().recipe);
  again.run(15);
  EXPECT_EQ(again.hash(), later.hash);
}

TEST(Session, ARestartBeginsTheScheduleAgain) {
  Session session(warming_litter(), true);
  for (int i = 0; i < 15; ++i) session.step();
  session.apply(Restart{});
  EXPECT_EQ(look_at(session).view().recipe, warming_litter());
}

TEST(Session, ARestartGoesBackToTheCheckpoint) {
  Simulation start(warming_litter());
  start.run(7);
  Session session(start.recipe(), true, 1, start.snapshot());
  for (int i = 0; i < 5; ++i) session.step();
  session.apply(Restart{});
  const LiveState again = look_at(session);
  EXPECT_EQ(again.view().step, 7);
  EXPECT_EQ(again.hash, start.hash());
}

TEST(Session, AnEditOfTheLitterRestartsIt) {
  Session session(small_litter(), true);
  for (int i = 0; i < 5; ++i) session.step();
  Params edited = small_litter();
  edited.pups = 4;
  session.apply(Edit{edited});
  const LiveState snapshot = look_at(session);
  EXPECT_EQ(snapshot.view().step, 0);
  EXPECT_EQ(snapshot.view().pups, 4);
  EXPECT_TRUE(snapshot.view().recipe.schedule.empty());
  EXPECT_EQ(snapshot.view().positions.points(), 54);
  EXPECT_EQ(snapshot.hash, Simulation(edited).hash());
  EXPECT_TRUE(session.running());
}

TEST(Session, ShowsWarningsUntilTheLitterIsANewOne) {
  Params params = small_litter();
  params.drive = 60;
  Session session(params, true);
  for (int i = 0; i < 200; ++i) session.step();
  LiveState snapshot = look_at(session);
  EXPECT_TRUE(snapshot.status.ok());
  ASSERT_FALSE(snapshot.warnings.empty());
  EXPECT_EQ(snapshot.warnings[0].kind, Warning::Kind::outside);
  session.apply(Restart{});
  session.fill(snapshot);
  EXPECT_TRUE(snapshot.warnings.empty());
}

TEST(Session, AnUnsoundEditIsNotTaken) {
  Session session(small_litter(), true);
  Params edited = small_litter();
  edited.rigidity = 2;
  session.apply(Edit{edited});
  session.step();
  const LiveState snapshot = look_at(session);
  EXPECT_THAT(snapshot.rejected, testing::HasSubstr("alpha"));
  EXPECT_EQ(snapshot.view().params, small_litter());
  EXPECT_EQ(snapshot.view().step, 1);
  session.apply(Edit{small_litter()});
  EXPECT_EQ(look_at(session).rejected, "");
}

TEST(Session, ABadStatusPausesUntilARestart) {
  Session session(runaway(), true);
  step_until_bad(session);
  ASSERT_FALSE(session.running());
  LiveState snapshot = look_at(session);
  EXPECT_FALSE(snapshot.status.ok());
  EXPECT_GE(snapshot.status.pup, 0);
  EXPECT_FALSE(snapshot.playing);

  session.apply(PlayPause{});
  EXPECT_FALSE(session.running());
  session.apply(Advance{3});
  EXPECT_FALSE(session.hurried());
  EXPECT_EQ(look_at(session).hash, snapshot.hash);

  session.apply(Restart{});
  snapshot = look_at(session);
  EXPECT_TRUE(snapshot.status.ok());
  EXPECT_EQ(snapshot.view().step, 0);
  EXPECT_TRUE(session.running()) << "it ran when the numbers went wrong";
}

TEST(Session, RestartIsTheSameLitterAgain) {
  Session session(small_litter(), false);
  const LiveState start = look_at(session);
  for (int i = 0; i < 7; ++i) session.step();
  EXPECT_NE(look_at(session).hash, start.hash);
  session.apply(Restart{});
  EXPECT_EQ(look_at(session).hash, start.hash);
}

TEST(Session, AdvancePausesAndMakesThatManySteps) {
  Session session(small_litter(), true);
  session.apply(Advance{3});
  EXPECT_FALSE(session.running());
  int steps = 0;
  for (; session.hurried(); ++steps) session.step();
  EXPECT_EQ(steps, 3);
  EXPECT_EQ(look_at(session).view().step, 3);
}

TEST(Session, SuspendedItWantsNothingAndThenGoesOn) {
  Session session(small_litter(), true);
  session.apply(Suspend{true});
  EXPECT_FALSE(session.running());
  session.apply(Suspend{false});
  EXPECT_TRUE(session.running());
}

TEST(Session, MeasuresEveryStep) {
  Simulation simulation(small_litter());
  Observer observer(simulation);
  simulation.step();
  observer.observe(simulation);

  Session session(small_litter(), true);
  session.step();
  ASSERT_TRUE(look_at(session).observables);
  EXPECT_EQ(look_at(session).observables->mean_tb, observer.last().mean_tb);
  EXPECT_EQ(look_at(session).observables->flow, observer.last().flow);
  EXPECT_EQ(look_at(session).history.last(), 1);
}

TEST(Session, RecordsWhatTheFieldInColorsNeeds) {
  Session session(small_litter(), true);
  for (const char* name : {"tb", "group", "strain", "side", "speed"}) {
    const LitterField& field = *find_field(name);
    session.apply(ColorBy{&field});
    session.step();
    EXPECT_TRUE(is_known(field, look_at(session).view())) << name;
  }
  const LiveState seen = look_at(session);
  EXPECT_FALSE(is_known(*find_field("strain"), seen.view())) << "only what is shown is recorded";
  session.apply(Watch{.parts = {Part::strain}, .velocities = true});
  session.step();
  EXPECT_TRUE(is_known(*find_field("strain"), look_at(session).view()));
  EXPECT_FALSE(look_at(session).view().velocities.empty());
  Simulation simulation(small_litter());
  simulation.run(5);
  EXPECT_EQ(seen.hash, simulation.hash());
}

TEST(Session, AtRestTheLastStepIsTakenAgainForWhatIsNowShown) {
  Session session(small_litter(), false);
  for (int i = 0; i < 5; ++i) session.step();
  const LiveState before = look_at(session);
  session.apply(Watch{.parts = {Part::strain, Part::sides}});
  while (session.hurried()) session.step();
  const LiveState after = look_at(session);
  EXPECT_TRUE(is_known(*find_field("strain"), after.view()));
  EXPECT_TRUE(is_known(*find_field("side"), after.view()));
  EXPECT_EQ(after.hash, before.hash);
  ASSERT_TRUE(after.observables);
  EXPECT_EQ(after.observables->flow, before.observables->flow);
}

TEST(Session, LookingChangesNothing) {
  Session seen(small_litter(), true), unseen(small_litter(), true);
  seen.apply(Watch{.parts = {Part::strain, Part::sides}});
  for (int i = 0; i < 50; ++i) {
    seen.step();
    unseen.step();
  }
  EXPECT_EQ(look_at(seen).hash, look_at(unseen).hash);
}

TEST(Session, SaysWhetherThereIsAnythingNew) {
  Session session(small_litter(), true);
  EXPECT_TRUE(session.changed());
  look_at(session);
  EXPECT_FALSE(session.changed());
  session.step();
  EXPECT_TRUE(session.changed());
}

TEST(Session, OpenTakesAnotherRecipeWithItsSchedule) {
  Session session(Params{}, false);
  session.step();
  Params other;
  other.pups = 3;
  other.seed = 8;
  other.schedule.set(2, static_cast<std::size_t>(find_parameter("ta") - parameters().data()), 0.1);
  session.apply(Open{other, {}});
  LiveState state;
  for (int i = 0; i < 5; ++i) session.step();
  session.fill(state);
  Simulation simulation(other);
  simulation.run(5);
  EXPECT_EQ(state.hash, simulation.hash());
  EXPECT_EQ(state.view().recipe, other);
  session.apply(Restart{});
  session.fill(state);
  EXPECT_EQ(state.view().recipe, other) << "a restart keeps the schedule";
}

TEST(Session, OpenGoesOnFromASnapshot) {
  Params params;
  params.seed = 4;
  Simulation simulation(params);
  simulation.run(20);
  Session session(Params{}, false);
  session.apply(Open{params, simulation.snapshot()});
  simulation.run(5);
  for (int i = 0; i < 5; ++i) session.step();
  LiveState state;
  session.fill(state);
  EXPECT_EQ(state.view().step, 25);
  EXPECT_EQ(state.hash, simulation.hash());
}

}  // namespace
}  // namespace pupflow::window
