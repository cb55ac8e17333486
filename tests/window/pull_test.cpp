// The spring with which the mouse draws a pup.
#include "app/window/session/pull.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/window/session_words.h"

namespace pupflow::window {
namespace {

double distance(Session& session, int pup, const std::array<double, 3>& target) {
  const Eigen::Vector3d centre = look_at(session).view().positions.mean(pup);
  return (centre - Eigen::Vector3d(target[0], target[1], target[2])).norm();
}

Params one_pup() {
  Params params;
  params.pups = 1;
  params.seed = 3;
  params.steps = 100000;
  return params;
}

TEST(Pull, APupFollowsInAThirdOfASecond) {
  for (const double dt : {0.001, 0.004, 0.01}) {
    Params params = one_pup();
    params.dt = dt;
    Session session(params, true);
    for (double t = 0; t < 2; t += dt) session.step();  // it lies on the floor
    const Eigen::Vector3d centre = look_at(session).view().positions.mean(0);
    const std::array<double, 3> target{centre.x() / 2, centre.y() / 2 + 0.5, centre.z() + 0.3};
    const double before = distance(session, 0, target);
    session.apply(Pull{0, target});
    for (double t = 0; t < 0.4; t += dt) session.step();
    EXPECT_LT(distance(session, 0, target), 0.1 * before) << dt;
  }
}

TEST(Pull, TheNumbersStaySoundForAnyBodyAndStep) {
  for (const double alpha : {0.0, 0.3, 0.7, 1.0}) {
    for (const double dt : {1e-5, 0.001, 0.01, 0.02}) {
      for (const bool moves : {false, true}) {
        Params params = one_pup();
        params.pups = 3;
        params.rigidity = alpha;
        params.dt = dt;
        Session session(params, true);
        for (int i = 0; i < 100; ++i) session.step();
        for (int i = 0; i < 600; ++i) {
          const double way = moves && i / 20 % 2 == 1 ? -1.5 : 1.5;
          session.apply(Pull{1, {way, 0, 0.5}});
          session.step();
        }
        const LiveState state = look_at(session);
        ASSERT_TRUE(state.status.ok()) << alpha << ' ' << dt << ' ' << state.status.message();
        const Eigen::Vector3d centre = state.view().positions.mean(1);
        EXPECT_LT(centre.norm(), 10) << alpha << ' ' << dt;
      }
    }
  }
}

/// A point that nothing else acts on, stepped as the engine steps the centre of a cloud.
TEST(Pull, HeldForSomeStepsTheSpringIsDampedAtAnyStep) {
  for (double dt = 1e-6; dt < 100; dt *= 1.7) {
    const std::int64_t steps = pull_steps(dt);
    const double held_for = static_cast<double>(steps) * dt;
    Params params = one_pup();
    params.dt = dt;
    params.gravity = 0;
    Snapshot pup = Simulation(params).snapshot();
    double x = 0.2, v = 0, largest = 0;
    for (int hold = 0; hold < 200; ++hold) {
      for (std::size_t i = 0; i < pup.positions.size(); ++i) {
        pup.positions[i] = i % 3 == 0 ? x : 0;
        pup.velocities[i] = i % 3 == 0 ? v : 0;
      }
      const double force = pull_force(pup.view(), 0, {0, 0, 0})[0];
      const std::int64_t taken = std::min<std::int64_t>(steps, 1000);  // many small ones: one long
      for (std::int64_t i = 0; i < taken; ++i) {
        v += held_for / static_cast<double>(taken) * force;
        x += held_for / static_cast<double>(taken) * v;
      }
      if (hold > 0) largest = std::max(largest, std::abs(x));
    }
    EXPECT_LE(largest, 0.2) << dt;
    EXPECT_LT(std::abs(x), 0.002) << dt;
  }
}

TEST(Pull, IsOneSpanOnTheTimelineAndStopsWhenLetGo) {
  Params params = one_pup();
  params.pups = 2;
  Session session(params, true);
  for (int i = 0; i < 50; ++i) session.step();
  for (int i = 0; i < 60; ++i) {
    session.apply(Pull{1, {0.01 * i, 0, 0.5}});
    session.step();
  }
  session.apply(Pull{});
  for (int i = 0; i < 60; ++i) session.step();
  const LiveState state = look_at(session);
  ASSERT_EQ(state.timeline.marks.size(), 1u);
  EXPECT_EQ(state.timeline.marks[0].kind, Timeline::Kind::pull);
  EXPECT_EQ(state.timeline.marks[0].step, 50);
  EXPECT_EQ(state.timeline.marks[0].until, 110);
  EXPECT_EQ(state.timeline.marks[0].text, "pup 1 pulled");
  for (const Change& change : state.view().recipe.schedule.changes()) {
    EXPECT_EQ(change.pup, 1);
    EXPECT_LE(change.until, 110);
  }
  Simulation again(state.view().recipe);
  again.run(170);
  EXPECT_EQ(again.hash(), state.hash);
  session.apply(Pull{7, {0, 0, 0}});
  session.apply(Pull{0, {NAN, 0, 0}});
  session.step();
  EXPECT_EQ(look_at(session).timeline.marks.size(), 1u) << "nobody there, and nowhere";
}

TEST(Pull, TheRecipeHoldsABoundedNumber) {
  Params params = one_pup();
  params.face_points = 2;
  params.dt = 0.03;  // one force a step
  constexpr std::size_t kMore = 10;
  for (std::size_t i = 0; i < Session::kMostPulls - kMore; ++i) {
    Change change{.step = 5, .until = 6, .settings = {}, .pup = 0, .action = {}};
    change.action.force = {0, 0, 1e-6};
    params.schedule.add(change);
  }
  Session session(params, true);
  session.apply(Pull{0, {0, 0, 0.3}});
  for (std::size_t i = 0; i < 2 * kMore; ++i) session.step();
  const LiveState state = look_at(session);
  EXPECT_EQ(state.view().recipe.schedule.changes().size(), Session::kMostPulls);
  EXPECT_NE(state.rejected.find("restart to pull again"), std::string::npos);
}

}  // namespace
}  // namespace pupflow::window
