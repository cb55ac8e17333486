// Bad numbers are reported at the very step, by stage, pup and point, and nothing is repaired.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/litter.h"

namespace pupflow {
namespace {

using testing::Points;

TEST(Status, ANonFinitePointIsNamed) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Simulation s{Params{}};
    s.run(5);
    Points x = testing::of_pup(s, 7, testing::all_positions(s));
    const Points v = testing::of_pup(s, 7, testing::all_velocities(s));
    x[123].y() = bad;
    testing::place(s, 7, x, v);
    const Status status = s.step();
    EXPECT_EQ(status.kind, Status::Kind::non_finite);
    EXPECT_EQ(status.step, 6);
    EXPECT_EQ(status.pup, 7);
    EXPECT_GE(status.point, 0);
  }
}

TEST(Status, ABadStatusStays) {
  Simulation s{Params{}};
  Points x = testing::of_pup(s, 0, testing::all_positions(s));
  x[0].x() = std::nan("");
  testing::place(s, 0, x, Points(x.size(), Eigen::Vector3d::Zero()));
  EXPECT_FALSE(s.step().ok());
  const std::int64_t steps = s.steps_done();
  EXPECT_FALSE(s.run(10).ok());
  EXPECT_EQ(s.steps_done(), steps);
  EXPECT_FALSE(s.status().ok());
}

TEST(Status, ARunawayPointHasDiverged) {
  Params p = testing::weightless();
  p.alpha = 0;  // nothing holds the points together
  Simulation s(p);
  Points x = testing::all_positions(s), v(x.size(), Eigen::Vector3d::Zero());
  v[42] = Eigen::Vector3d(0, 0, 100);
  testing::place(s, 0, x, v);
  const Status status = s.run(100);
  EXPECT_EQ(status.kind, Status::Kind::diverged);
  EXPECT_EQ(status.stage, Stage::predict);
  EXPECT_EQ(status.point, 42);
  EXPECT_EQ(status.step,
            26);  // 100 radii of 0.25 at one unit a step, the mean moving a little along
  EXPECT_EQ(status.message(), "diverged at step 26, stage predict, pup 0, point 42");
}

TEST(Status, FiniteGrowthAtBetaOneIsReported) {
  Params p;
  p.beta = 1;
  Simulation s(p);
  const Status status = s.run(20000);
  EXPECT_EQ(status.kind, Status::Kind::diverged);
  EXPECT_EQ(status.stage, Stage::shape_match);
  EXPECT_EQ(status.step, s.steps_done() + 1);
}

TEST(Status, TheExplicitFormBlowsUpAndSaysSo) {
  Params p;
  p.pups = 1;
  p.beta = 0;
  p.integrator = Integrator::explicit_;
  Simulation s(p);
  EXPECT_FALSE(s.run(2000).ok());
}

TEST(Status, AnInfiniteTemperatureNamesThePup) {
  Params p;
  p.g = 1e308;
  p.dt = 10;
  p.heat = HeatRule::euler;
  Simulation s(p);
  const Status status = s.step();
  EXPECT_EQ(status.stage, Stage::heat);
  EXPECT_EQ(status.pup, 0);
  EXPECT_EQ(status.point, -1);
}

TEST(Status, FlatAndCollapsedCloudsRecoverAndAreCounted) {
  Params p = testing::weightless();
  p.beta = 0;
  Simulation s(p);
  Points x = testing::all_positions(s);
  for (auto& point : x) point = Eigen::Vector3d(point.x(), point.y(), 10);
  testing::place(s, 0, x, Points(x.size(), Eigen::Vector3d::Zero()));
  EXPECT_TRUE(s.run(100).ok());
  EXPECT_GT(s.rotation_fallbacks(), 0);
  for (const auto& point : testing::all_positions(s))
    EXPECT_NEAR((point - s.centre(0)).norm(), 0.25, 1e-6);
}

TEST(Status, OrdinaryRunsNeedNoFallback) {
  Simulation s{Params{}};
  EXPECT_TRUE(s.run(800).ok());
  EXPECT_EQ(s.rotation_fallbacks(), 0);
}

}  // namespace
}  // namespace pupflow
