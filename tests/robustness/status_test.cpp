// Bad numbers are reported at the very step, by stage, pup and point, and nothing is repaired.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

using testing::Points;

TEST(Status, ANonFinitePointIsNamed) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (const bool moving : {false, true}) {
      Simulation s{Params{}};
      s.run(5);
      Points x = testing::of_pup(s, 7, testing::all_positions(s));
      Points v = testing::of_pup(s, 7, testing::all_velocities(s));
      (moving ? v : x)[123].y() = bad;
      testing::place(s, 7, x, v);
      const Status status = s.step();
      EXPECT_EQ(status.kind, Status::Kind::non_finite);
      EXPECT_EQ(status.stage, Stage::boundary);
      EXPECT_EQ(status.step, 6);
      EXPECT_EQ(status.pup, 7);
      EXPECT_EQ(status.point, 123);
    }
  }
}

TEST(Status, ANumberTooLargeForFloatIsNamed) {
  Params p;
  p.precision = Precision::float_;
  Simulation s(p);
  Points x = testing::of_pup(s, 3, testing::all_positions(s));
  x[5].z() = 1e300;
  testing::place(s, 3, x, Points(x.size(), Eigen::Vector3d::Zero()));
  EXPECT_EQ(s.step().message(), "non-finite number at step 1, stage boundary, pup 3, point 5");
}

TEST(Status, AHeadingThatIsNoNumberIsRefused) {
  Simulation s{Params{}};
  EXPECT_THROW(s.set_heading(0, std::nan("")), std::invalid_argument);
  EXPECT_THROW(s.set_heading(0, HUGE_VAL), std::invalid_argument);
  Snapshot snapshot = s.snapshot();
  snapshot.body_temperature[2] = std::nan("");
  EXPECT_THROW(Simulation{snapshot}, std::invalid_argument);
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
  p.rigidity = 0;  // nothing holds the points together
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

// Twelve pups land on each other: with a volume factor of up to 3 whatever beta is, bodies at beta
// = 1 were 100 radii long within some hundred steps.
TEST(Status, NearBetaOneBodiesDoNotFeedOnTheirSize) {
  for (const double beta : {0.95, 0.98, 1.0}) {
    for (const double alpha : {0.3, 0.7, 1.0}) {
      Params p;
      p.rigidity = alpha;
      p.deformation = beta;
      p.precision = Precision::float_;
      Simulation s(p);
      EXPECT_TRUE(s.run(1500).ok()) << alpha << ' ' << beta << ' ' << s.status().message();
      for (int pup = 0; pup < s.pups(); ++pup) {
        for (const auto& point : testing::of_pup(s, pup, testing::all_positions(s)))
          EXPECT_LT((point - s.view().positions.mean(pup)).norm(),
                    20 * p.pup_radius);  // the arena's diameter: 16
      }
    }
  }
}

// Beyond the wall a step makes v <- (v - 1)/2 + h f and moves by h (v_before - 1)/2 + h v: outwards
// for ever when h f > 2/3.
TEST(Status, ADriveThatOutrunsTheWallIsReported) {
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    Params p;
    p.pups = 1;
    p.precision = precision;
    p.drive = 60;
    Simulation held(p);
    EXPECT_TRUE(held.run(20000).ok()) << held.status().message();
    p.drive = 75;
    Simulation lost(p);
    const Status status = lost.run(20000);
    EXPECT_EQ(status.kind, Status::Kind::escaped);
    EXPECT_EQ(status.pup, 0);
    const Eigen::Vector3d centre = lost.view().positions.mean(0);
    const double beyond = std::hypot(centre.x(), centre.y()) - p.arena_radius;
    EXPECT_NEAR(beyond, 100 * p.pup_radius, 2 * p.pup_radius);
    EXPECT_THAT(status.message(), ::testing::StartsWith("escaped from the arena at step "));
  }
}

TEST(Status, NobodyIsSoonTooFarOutToBeSeen) {
  Params p;
  p.drive = 1e300;  // all points of a pup fall into one there
  Simulation s(p);
  const Status status = s.run(10);
  EXPECT_EQ(status.kind, Status::Kind::escaped);
  EXPECT_EQ(status.step, 1);
}

TEST(Status, EulerHeatBeyondItsRegionIsReported) {
  Params p;
  p.pups = 1;
  p.heat = HeatRule::euler;
  for (const double k1_h : {1.5, 1.99, 2.01, 2.5, 20.0}) {
    p.air_conductance = k1_h / p.dt;
    Simulation s(p);
    const Status status = s.run(3000);
    EXPECT_EQ(status.ok(), k1_h < 2) << k1_h;
    if (status.ok()) continue;
    EXPECT_EQ(status.kind, Status::Kind::diverged);
    EXPECT_EQ(status.stage, Stage::heat);
    // |1 - k1 h|^n |T_b(0) - T_eq| k1 h > 100
    const double equilibrium = p.ambient_temperature + p.thermogenesis / p.air_conductance;
    const double n =
        std::log(100 / (k1_h * (p.initial_temperature - equilibrium))) / std::log(k1_h - 1);
    EXPECT_NEAR(static_cast<double>(status.step), n + 1, 1) << k1_h;
  }
}

TEST(Status, TheExplicitFormBlowsUpAndSaysSo) {
  Params p;
  p.pups = 1;
  p.deformation = 0;
  p.integrator = Integrator::explicit_;
  Simulation s(p);
  EXPECT_FALSE(s.run(2000).ok());
}

TEST(Status, AnInfiniteTemperatureNamesThePup) {
  Params p;
  p.thermogenesis = 1e308;
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
  p.deformation = 0;
  Simulation s(p);
  Points x = testing::all_positions(s);
  for (auto& point : x) point = Eigen::Vector3d(point.x(), point.y(), 10);
  testing::place(s, 0, x, Points(x.size(), Eigen::Vector3d::Zero()));
  EXPECT_TRUE(s.run(100).ok());
  EXPECT_GT(s.rotation_fallbacks(), 0);
  for (const auto& point : testing::all_positions(s))
    EXPECT_NEAR((point - s.view().positions.mean(0)).norm(), 0.25, 1e-6);
}

TEST(Status, OrdinaryRunsNeedNoFallback) {
  Simulation s{Params{}};
  EXPECT_TRUE(s.run(800).ok());
  EXPECT_EQ(s.rotation_fallbacks(), 0);
}

}  // namespace
}  // namespace pupflow
