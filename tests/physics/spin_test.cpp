// What a spinning, weightless pup keeps: linear momentum exactly, spin by a known law.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <cstdio>

#include "pupflow/geometry.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

using testing::Points;

Simulation spinning(double alpha, double beta, double omega) {
  Params p = testing::weightless();
  p.rigidity = alpha;
  p.deformation = beta;
  Simulation s(p);
  Points points, velocities;
  for (const auto& q : cube_sphere(7, 0.25)) {
    points.push_back(q + Eigen::Vector3d(0, 0, 100));
    velocities.push_back(omega * Eigen::Vector3d::UnitZ().cross(q) +
                         Eigen::Vector3d(0.3, -0.2, 0.1));
  }
  testing::place(s, 0, points, velocities);
  return s;
}

Eigen::Vector3d momentum(const Simulation& s) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& v : testing::all_velocities(s)) sum += v / s.points();
  return sum;
}

/// Angular momentum about the centre, per point.
Eigen::Vector3d spin(const Simulation& s) {
  const Points x = testing::all_positions(s), v = testing::all_velocities(s);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += (x[i] - s.view().positions.mean(0)).cross(v[i]) / s.points();
  return sum;
}

/// Direction of the first point, seen from above.
double azimuth(const Simulation& s) {
  const Eigen::Vector3d arm = testing::all_positions(s)[0] - s.view().positions.mean(0);
  return std::atan2(arm.y(), arm.x());
}

TEST(Spin, LinearMomentumIsKeptToRounding) {
  for (const double alpha : {0.0, 0.3, 0.7, 1.0}) {
    for (const double beta : {0.0, 0.5, 0.9}) {
      Simulation s = spinning(alpha, beta, 3);
      const Eigen::Vector3d before = momentum(s);
      ASSERT_TRUE(s.run(500).ok());
      EXPECT_LT((momentum(s) - before).norm(), 1e-11) << alpha << ' ' << beta;
    }
  }
}

TEST(Spin, ARigidPupLosesSpinByTheKnownLaw) {
  // Turning by phi in one step, it turns by phi' in the next: sin phi' = sin phi / sqrt(5 - 4 cos
  // phi).
  for (const double omega : {0.5, 5.0, 50.0}) {
    Simulation s = spinning(1, 0, omega);
    s.step();
    double before = azimuth(s);
    s.step();
    double phi = std::remainder(azimuth(s) - before, 2 * M_PI);
    ASSERT_GT(phi, 0);
    for (int m = 0; m < 200; ++m) {
      before = azimuth(s);
      s.step();
      const double next = std::remainder(azimuth(s) - before, 2 * M_PI);
      ASSERT_NEAR(std::sin(next), std::sin(phi) / std::sqrt(5 - 4 * std::cos(phi)), 1e-11) << omega;
      phi = next;
    }
  }
}

TEST(Spin, SlowSpinIsDampedAsOmegaSquaredTimesDt) {
  Simulation s = spinning(1, 0, 2);
  s.step();
  const double before = spin(s).z();
  s.run(100);  // one second
  // d omega/dt = -omega^3 h: 1/omega^2 grows by 2 h t.
  const double expected = before / std::sqrt(1 + 2 * 0.01 * 4);
  EXPECT_NEAR(spin(s).z() / expected, 1, 0.01);
}

TEST(Spin, OtherSettingsKeepNearlyAllOfASlowSpin) {
  // The table of docs/model.md; run this test with --gtest_filter=Spin.Other* to print it.
  std::printf(
      "share of a spin of 1 rad/s left after one second\nalpha\\beta   0.0     0.5     0.9\n");
  for (const double alpha : {0.3, 0.7, 1.0}) {
    std::printf("%5.1f", alpha);
    for (const double beta : {0.0, 0.5, 0.9}) {
      Simulation s = spinning(alpha, beta, 1);
      const double before = spin(s).z();
      ASSERT_TRUE(s.run(100).ok());
      const double left = spin(s).z() / before;
      std::printf("  %.4f", left);
      EXPECT_GT(left, 0.9) << alpha << ' ' << beta;
      EXPECT_LT(left, 1.0) << alpha << ' ' << beta;
    }
    std::printf("\n");
  }
}

}  // namespace
}  // namespace pupflow
