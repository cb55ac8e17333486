// Two litters beside each other.
#include <gmock/gmock.h>

#include "tests/window/session_words.h"

namespace pupflow::window {
namespace {

using testing::HasSubstr;

void compare(Session& session, std::string_view name, double value, bool from_now = false) {
  Params with = session.params();
  find_parameter(name)->set(with, value);
  have(session, Compare{with, from_now});
}

/// The parameters in which the two litters differ.
std::vector<std::string> differences(const LiveState& state) {
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters()) {
    if (parameter.get(state.view().params) != parameter.get(state.second->view().params)) {
      names.emplace_back(parameter.name);
    }
  }
  return names;
}

/// Whether the second litter is what its recipe comes to without any window.
bool repeats(const LiveState& state) {
  const LitterView second = state.second->view();
  Simulation again(second.recipe);
  again.run(second.step);
  for (int pup = 0; pup < second.pups; ++pup) {
    for (int point = 0; point < second.points; ++point) {
      const Eigen::Vector3f a = again.view().positions(pup, point).cast<float>();
      if (a != second.positions(pup, point).cast<float>()) return false;
    }
  }
  return true;
}

TEST(Compare, BothBeginAnewAndStepTogether) {
  Session session(small_litter(), true);
  play(session, 140);
  set(session, "gravity", 8);
  play(session, 60);
  const LiveState first = look_at(session);
  compare(session, "ta", 0.9);
  EXPECT_EQ(look_at(session).view().step, 0);
  EXPECT_EQ(look_at(session).timeline.last, 200) << "its run is still known";
  EXPECT_TRUE(session.running()) << "it ran before";
  play(session, 200);
  const LiveState state = look_at(session);
  EXPECT_EQ(state.hash, first.hash);
  ASSERT_TRUE(state.second);
  EXPECT_EQ(state.second->view().step, 200);
  EXPECT_THAT(differences(state), testing::ElementsAre("ta")) << "the edit of gravity recurs";
  EXPECT_EQ(state.second->history.last(), 200);
  EXPECT_TRUE(repeats(state));
  have(session, Compare{});
  EXPECT_FALSE(look_at(session).second);
}

TEST(Compare, FromThePresentState) {
  Session session(small_litter(), true);
  play(session, 130);
  compare(session, "drive", 5, true);
  const LiveState begun = look_at(session);
  EXPECT_EQ(begun.view().step, 130);
  ASSERT_TRUE(begun.second);
  EXPECT_EQ(begun.second->view().step, 130);
  EXPECT_EQ(begun.second->history.last(), 130) << "the past is the same";
  play(session, 100);
  EXPECT_THAT(differences(look_at(session)), testing::ElementsAre("drive"));
  EXPECT_TRUE(repeats(look_at(session)));
  compare(session, "seed", 4, true);
  EXPECT_THAT(look_at(session).rejected, HasSubstr("seed defines the litter"));
  EXPECT_FALSE(look_at(session).second);
}

TEST(Compare, GoingBackMovesBoth) {
  Session session(small_litter(), true);
  compare(session, "seed", 12);
  play(session, 230);
  const LiveState end = look_at(session);
  have(session, GoTo{77});
  EXPECT_EQ(look_at(session).second->view().step, 77);
  EXPECT_TRUE(repeats(look_at(session)));
  have(session, GoTo{230});
  EXPECT_EQ(look_at(session).hash, end.hash);
  EXPECT_EQ(look_at(session).second->view().positions.mean(0),
            end.second->view().positions.mean(0));
}

TEST(Compare, EditsActOnBothButForWhatDiffers) {
  Session session(small_litter(), true);
  compare(session, "ta", 0.9);
  play(session, 20);
  set(session, "gravity", 6);
  set(session, "ta", 0.1);
  have(session, RampTo{place("tp"), 0.5, 20});
  have(session, RampTo{place("ta"), 0.2, 20});
  have(session, Pull{1, {0.3, 0, 0.4}});
  play(session, 30);
  const LiveState state = look_at(session);
  EXPECT_EQ(state.second->view().params.gravity, 6);
  EXPECT_EQ(state.second->view().params.ambient_temperature, 0.9);
  EXPECT_EQ(state.view().params.ambient_temperature, 0.2);
  EXPECT_THAT(differences(state), testing::ElementsAre("ta"));
  EXPECT_TRUE(repeats(state));
  set(session, "pups", 4);
  EXPECT_EQ(look_at(session).second->view().pups, 4);
  EXPECT_EQ(look_at(session).second->view().step, 0);
  EXPECT_THAT(differences(look_at(session)), testing::ElementsAre("ta"));
}

TEST(Compare, ABranchIsOneForBoth) {
  Session session(small_litter(), true);
  compare(session, "ta", 0.9);
  play(session, 150);
  have(session, GoTo{60});
  set(session, "ta", 0.2);  // of the first one only
  play(session, 10);
  EXPECT_EQ(look_at(session).second->view().step, 70);
  have(session, SwapFuture{});
  EXPECT_EQ(look_at(session).view().step, 150);
  EXPECT_EQ(look_at(session).second->view().step, 150);
  EXPECT_TRUE(repeats(look_at(session)));
}

TEST(Compare, AFutureFromBeforeTheComparisonIsComparedAnew) {
  Session session(small_litter(), true);
  play(session, 150);
  have(session, GoTo{60});
  set(session, "gravity", 8);  // the future up to step 150 is the other one
  play(session, 40);
  compare(session, "ta", 0.9);
  play(session, 20);
  have(session, SwapFuture{});
  LiveState state = look_at(session);
  EXPECT_EQ(state.rejected, "");
  EXPECT_EQ(state.view().step, 0) << "both begin anew";
  EXPECT_EQ(state.timeline.last, 150) << "in the future that was left";
  ASSERT_TRUE(state.second);
  play(session, 100);
  state = look_at(session);
  EXPECT_EQ(state.view().params.gravity, small_litter().gravity);
  EXPECT_EQ(state.view().step, state.second->view().step);
  EXPECT_THAT(differences(state), testing::ElementsAre("ta"));
  EXPECT_TRUE(repeats(state));
  have(session, SwapFuture{});
  play(session, 100);
  state = look_at(session);
  EXPECT_EQ(state.view().params.gravity, 8) << "and back again";
  EXPECT_THAT(differences(state), testing::ElementsAre("ta"));
  EXPECT_TRUE(repeats(state));
}

TEST(Compare, SeesWhereTheTwoPart) {
  Session session(small_litter(), true);
  compare(session, "drive", 5, true);
  Simulation a(small_litter());
  Params other = small_litter();
  other.drive = 5;
  Simulation b(other);
  std::int64_t expected = -1;
  for (std::int64_t step = 1; step <= 400 && expected < 0; ++step) {
    a.step();
    b.step();
    for (int pup = 0; pup < 3; ++pup) {
      const double apart = (a.view().positions.mean(pup) - b.view().positions.mean(pup)).norm();
      if (apart > a.params().pup_radius / 2) expected = step;
    }
  }
  ASSERT_GT(expected, 1);
  play(session, 400);
  EXPECT_EQ(look_at(session).diverged_at, expected);
  have(session, GoTo{expected - 1});
  EXPECT_EQ(look_at(session).diverged_at, expected);
  set(session, "gravity", 9);
  EXPECT_EQ(look_at(session).diverged_at, std::nullopt) << "in this future they did not yet";
  play(session, 100);
  EXPECT_TRUE(look_at(session).diverged_at);
  have(session, Compare{});
  EXPECT_FALSE(look_at(session).diverged_at);
}

TEST(Compare, ABadLitterStopsBothAndCanBeGoneBackFrom) {
  Session session(small_litter(), true);
  Params with = small_litter();
  with.heat = HeatRule::euler;
  with.air_conductance = 500;
  have(session, Compare{with});
  for (int i = 0; i < 3000 && session.running(); ++i) session.step();
  const LiveState state = look_at(session);
  EXPECT_FALSE(state.playing);
  EXPECT_FALSE(state.second->status.ok());
  have(session, GoTo{3});
  EXPECT_TRUE(look_at(session).second->status.ok());
  EXPECT_EQ(look_at(session).second->view().step, 3);
}

TEST(Compare, ARunFromACheckpoint) {
  Simulation start(small_litter());
  start.run(130);
  Session session(start.recipe(), true, 1, start.snapshot());
  play(session, 30);
  compare(session, "pups", 4);
  EXPECT_THAT(look_at(session).rejected, HasSubstr("began from a checkpoint"));
  compare(session, "ta", 0.9);
  EXPECT_EQ(look_at(session).second->view().step, 130);
  play(session, 20);
  EXPECT_TRUE(repeats(look_at(session)));
  EXPECT_THAT(differences(look_at(session)), testing::ElementsAre("ta"));
}

// The second litter's former run ends at step 0: it was begun, and both were begun anew before it took a step.
TEST(Compare, FormerRunsOfDifferentLengthsAreGoneToAtTheSameStep) {
  Session session(small_litter(), true);
  play(session, 60);
  compare(session, "ta", 0.9);
  set(session, "pups", 2);
  play(session, 20);
  have(session, SwapFuture{});
  const LiveState state = look_at(session);
  ASSERT_TRUE(state.second);
  EXPECT_EQ(state.view().step, 60);
  EXPECT_EQ(state.second->view().step, 60);
}

}  // namespace
}  // namespace pupflow::window
