// What must not matter: the order of the pups, and where north is.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>

#include "engine/rng.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

using testing::Points;

/// A litter that has fallen and touches, as the start of a comparison.
Simulation settled(Params p) {
  Simulation s(p);
  EXPECT_TRUE(s.run(400).ok());
  EXPECT_GT(s.view().touching.size(), 5u);
  return s;
}

/// A fresh simulation whose pup j is pup `from(j)` of `s`, turned by `angle` about the z axis.
template <class From>
Simulation rearranged(const Simulation& s, From from, double angle) {
  Simulation other(s.params());
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Points x = testing::all_positions(s), v = testing::all_velocities(s);
  for (int pup = 0; pup < s.pups(); ++pup) {
    Points positions = testing::of_pup(s, from(pup), x),
           velocities = testing::of_pup(s, from(pup), v);
    for (auto& p : positions) p = turn * p;
    for (auto& p : velocities) p = turn * p;
    testing::place(other, pup, positions, velocities);
    other.set_body_temperature(pup, s.view().tb[from(pup)]);
    other.set_heading(pup, s.view().heading[from(pup)] + angle);
  }
  return other;
}

/// `s` lifted off the floor. There many points are at exactly the same height, where by the rule
/// the lower index decides who is the upper one, and a relabelling matters.
Simulation lifted(Simulation s) {
  const Points x = testing::all_positions(s), v = testing::all_velocities(s);
  Rng random(1);
  for (int pup = 0; pup < s.pups(); ++pup) {
    Points positions = testing::of_pup(s, pup, x);
    for (auto& p : positions) p += Eigen::Vector3d(0, 0, random.uniform(3, 3.001));
    testing::place(s, pup, positions, testing::of_pup(s, pup, v));
  }
  return s;
}

TEST(Symmetry, RelabellingPupsChangesOnlyRounding) {
  for (const Heading heading : {Heading::course, Heading::body}) {
    Params p;
    p.ambient_temperature = 0.2;
    p.heading = heading;
    Simulation s = lifted(settled(p));
    const auto from = [&](int pup) { return (5 * pup + 3) % p.pups; };
    Simulation other = rearranged(s, from, 0);
    ASSERT_TRUE(s.run(10).ok());
    ASSERT_TRUE(other.run(10).ok());
    for (int pup = 0; pup < p.pups; ++pup) {
      EXPECT_LT((other.view().positions.mean(pup) - s.view().positions.mean(from(pup))).norm(),
                1e-9);
      EXPECT_NEAR(other.view().tb[pup], s.view().tb[from(pup)], 1e-9);
      EXPECT_NEAR(other.view().exposed[pup], s.view().exposed[from(pup)], 1e-12);
    }
  }
}

void expect_turned(const Simulation& s, const Simulation& other, double angle) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  for (int pup = 0; pup < s.pups(); ++pup) {
    EXPECT_LT((other.view().positions.mean(pup) - turn * s.view().positions.mean(pup)).norm(), 1e-9)
        << pup;
    EXPECT_NEAR(other.view().tb[pup], s.view().tb[pup], 1e-9);
    EXPECT_NEAR(std::remainder(other.view().heading[pup] - s.view().heading[pup] - angle, 2 * M_PI),
                0, 1e-8);
  }
}

TEST(Symmetry, TurningTheSceneTurnsTheResult) {
  for (const Heading heading : {Heading::course, Heading::body}) {
    Params p;
    p.ambient_temperature = 0.2;
    p.heading = heading;
    p.arena_radius = 100;  // nobody meets the wall, whose rule is no circle's
    Simulation s = settled(p);
    Simulation other = rearranged(
        s, [](int pup) { return pup; }, 0.7);
    s.run(10);
    other.run(10);
    expect_turned(s, other, 0.7);
  }
}

TEST(Symmetry, TheWallAllowsQuarterTurns) {
  Params p;
  p.ambient_temperature = 0.2;
  p.arena_radius = 0.9;  // everybody leans against it
  Simulation s = settled(p);
  Simulation other = rearranged(
      s, [](int pup) { return pup; }, M_PI / 2);
  s.run(10);
  other.run(10);
  expect_turned(s, other, M_PI / 2);
}

}  // namespace
}  // namespace pupflow
