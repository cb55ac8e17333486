// Laws of motion with known answers.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/cloud.h"
#include "pupflow/geometry.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

using testing::Points;

struct Setting {
  double alpha, beta;
  Precision precision;
};

class Falling : public ::testing::TestWithParam<Setting> {};

TEST_P(Falling, FollowsTheDiscreteLawOfFreeFall) {
  Params p;
  p.pups = 1;
  p.drive = 0;
  p.rigidity = GetParam().alpha;
  p.deformation = GetParam().beta;
  p.precision = GetParam().precision;
  Simulation s(p);
  Points points, still(294, Eigen::Vector3d::Zero());
  for (const auto& q : cube_sphere(7, 0.25)) points.push_back(q + Eigen::Vector3d(0, 0, 20));
  testing::place(s, 0, points, still);
  const double tolerance = p.precision == Precision::float_ ? 2e-4 : 1e-11;
  for (int m = 1; m <= 190; ++m) {
    ASSERT_TRUE(s.step().ok());
    ASSERT_NEAR(s.view().positions.mean(0).z(), 20 - 10 * 1e-4 * m * (m + 1) / 2, tolerance) << m;
  }
  EXPECT_LT(s.view().positions.mean(0).z(), 2);
}

INSTANTIATE_TEST_SUITE_P(Settings, Falling,
                         ::testing::Values(Setting{0.7, 0.5, Precision::double_},
                                           Setting{0.7, 0.5, Precision::float_},
                                           Setting{1, 0, Precision::double_},
                                           Setting{0, 0, Precision::double_}));

TEST(Motion, ADriveAloneAcceleratesAlongTheHeading) {
  Params p = testing::weightless();
  p.drive = 1;
  Simulation s(p);
  s.set_heading(0, 0.7);
  const Eigen::Vector3d start = s.view().positions.mean(0);
  s.run(100);
  const double travelled = 1e-4 * 100 * 101 / 2;
  EXPECT_NEAR(s.view().positions.mean(0).x() - start.x(), travelled * std::cos(0.7), 1e-12);
  EXPECT_NEAR(s.view().positions.mean(0).y() - start.y(), travelled * std::sin(0.7), 1e-12);
}

TEST(Motion, RigidPupsKeepAllDistances) {
  Params p;
  p.pups = 1;
  p.rigidity = 1;
  p.deformation = 0;
  Simulation s(p);
  const Points rest = testing::all_positions(s);
  s.run(300);  // falls, lands, rolls
  const Points now = testing::all_positions(s);
  for (std::size_t i = 0; i < rest.size(); i += 7) {
    for (std::size_t j = 0; j < i; j += 5) {
      ASSERT_NEAR((now[i] - now[j]).norm(), (rest[i] - rest[j]).norm(), 1e-12);
    }
  }
}

TEST(Motion, ASqueezedPupRingsDownAtTheRateOfTheTheory) {
  // A mode outside the fitted ones sees the full alpha: |lambda| = sqrt(1 - alpha) a step.
  Params p = testing::weightless();
  p.deformation = 0;
  p.rigidity = 0.7;
  Simulation s(p);
  const auto rest = cube_sphere(7, 0.25);
  const auto cloud = make_cloud<double>(rest);
  Points points, still(rest.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    points.push_back(rest[i] + Eigen::Vector3d(0, 0, 5 + 1e-3 * cloud.mode_row(4)[i]));
  }
  testing::place(s, 0, points, still);
  // Amplitude a_m of d'' recursion with d0 = 1, v0 = 0: Re of lambda^m solution.
  double d = 1e-3, v = 0;
  for (int m = 0; m < 40; ++m) {
    s.step();
    const double predicted = d + p.dt * v;
    d = (1 - p.rigidity) * predicted;
    v -= p.rigidity / p.dt * predicted;
    double amplitude = 0;
    const Points now = testing::all_positions(s);
    for (std::size_t i = 0; i < rest.size(); ++i) amplitude += now[i].z() * cloud.mode_row(4)[i];
    ASSERT_NEAR(amplitude, d, 1e-9) << m;
  }
  EXPECT_LT(std::abs(d), 1e-3 * std::pow(0.3, 19));
}

TEST(Motion, ExplicitAndPredictiveAgreeOnFreeFlight) {
  Params p = testing::weightless();
  p.gravity = 10;
  Simulation predictive(p);
  p.integrator = Integrator::explicit_;
  Simulation explicit_one(p);
  const auto lift = [](Simulation& s) {
    Points points;
    for (const auto& q : cube_sphere(7, 0.25)) points.push_back(q + Eigen::Vector3d(0, 0, 9));
    testing::place(s, 0, points, Points(points.size(), Eigen::Vector3d(1, 2, 3)));
  };
  lift(predictive);
  lift(explicit_one);
  predictive.run(50);
  explicit_one.run(50);
  EXPECT_LT((predictive.view().positions.mean(0) - explicit_one.view().positions.mean(0)).norm(),
            1e-12);
}

TEST(Motion, TheExplicitFormOfThePaperHasNoDamping) {
  // Its deformation modes have |lambda| = 1: a squeezed pup rings on, the predictive one comes to
  // rest.
  const auto energy_left = [](Integrator integrator) {
    Params p = testing::weightless();
    p.deformation = 0;
    p.integrator = integrator;
    Simulation s(p);
    Points points;
    const auto rest = cube_sphere(7, 0.25);
    for (const auto& q : rest)
      points.push_back(Eigen::Vector3d(q.x() * 1.02, q.y() / 1.02, q.z() + 5));
    testing::place(s, 0, points, Points(points.size(), Eigen::Vector3d::Zero()));
    s.run(400);
    double energy = 0;
    for (const auto& v : testing::all_velocities(s)) energy += v.squaredNorm();
    return energy;
  };
  EXPECT_LT(energy_left(Integrator::predictive), 1e-20);
  EXPECT_GT(energy_left(Integrator::explicit_), 1e-2);
}

}  // namespace
}  // namespace pupflow
