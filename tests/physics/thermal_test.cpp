// Known answers of heat.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>

#include "pupflow/geometry.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

using testing::Points;

TEST(Thermal, AnIsolatedPupFollowsTheClosedForm) {
  Params p;
  p.pups = 1;
  p.initial_temperature = 0.9;
  Simulation s(p);
  const double settled = p.ambient_temperature + p.thermogenesis / p.air_conductance;
  for (int m = 1; m <= 2000; ++m) {
    s.step();
    const double expected =
        settled + (p.initial_temperature - settled) * std::exp(-p.air_conductance * p.dt * m);
    ASSERT_NEAR(s.view().tb[0], expected, 1e-13) << m;
  }
  EXPECT_NEAR(s.view().tb[0], p.ambient_temperature + 0.0611, 5e-5);
}

TEST(Thermal, EulerConvergesToItAtFirstOrder) {
  const auto error = [](double dt) {
    Params p;
    p.pups = 1;
    p.initial_temperature = 0.9;
    p.heat = HeatRule::euler;
    p.dt = dt;
    Simulation s(p);
    s.run(std::lround(1 / dt));
    const double settled = p.ambient_temperature + p.thermogenesis / p.air_conductance;
    return s.view().tb[0] -
           (settled + (p.initial_temperature - settled) * std::exp(-p.air_conductance));
  };
  EXPECT_NEAR(error(0.01) / error(0.005), 2, 0.02);
}

/// Two pups side by side, mirror images of each other, so that their contact areas are equal.
Simulation mirrored_pair(const Params& p) {
  Simulation s(p);
  Points left, right;
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()) *
                                Eigen::AngleAxisd(0.9, Eigen::Vector3d::UnitY()))
                                   .toRotationMatrix();
  for (const auto& q : cube_sphere(7, 0.25)) {
    const Eigen::Vector3d at = turn * q + Eigen::Vector3d(-0.27, 0, 1);
    left.push_back(at);
    right.emplace_back(-at.x(), at.y(), at.z());
  }
  const Points still(left.size(), Eigen::Vector3d::Zero());
  testing::place(s, 0, left, still);
  testing::place(s, 1, right, still);
  return s;
}

TEST(Thermal, TouchingPupsExchangeEqualAmounts) {
  Params p = testing::weightless();
  p.pups = 2;
  p.thermogenesis = 0;
  p.air_conductance = 0;  // nothing but exchange
  Simulation s = mirrored_pair(p);
  s.set_body_temperature(0, 0.8);
  s.set_body_temperature(1, 0.4);
  s.step();
  ASSERT_LT(s.view().exposed[0], 1);
  ASSERT_EQ(s.view().exposed[0], s.view().exposed[1]);
  const double lost = 0.8 - s.view().tb[0], gained = s.view().tb[1] - 0.4;
  EXPECT_GT(lost, 0);
  EXPECT_NEAR(lost, gained, 1e-15);
  const double area = 1 - s.view().exposed[0];
  EXPECT_NEAR(lost, 0.4 * (1 - std::exp(-p.contact_conductance * area * p.dt)), 1e-15);
}

TEST(Thermal, AHuddleIsWarmerThanAPupAlone) {
  Params p;
  p.ambient_temperature = 0.1;
  Simulation s(p);
  s.run(1500);
  double mean = 0;
  for (const double tb : s.view().tb) mean += tb / p.pups;
  EXPECT_GT(mean, p.ambient_temperature + p.thermogenesis / p.air_conductance + 0.01);
}

}  // namespace
}  // namespace pupflow
