#include "engine/steering.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "engine/cloud.h"
#include "engine/elementary.h"
#include "pupflow/geometry.h"

namespace pupflow {
namespace {

TEST(Turn, GoesTowardsWarmthWhenColdAndAwayWhenHot) {
  const Params p;  // left is counter-clockwise: a positive turn
  EXPECT_GT(turn(p, 0.3, 0.5, 0.2), 0);
  EXPECT_LT(turn(p, 0.3, 0.2, 0.5), 0);
  EXPECT_LT(turn(p, 0.9, 0.5, 0.2), 0);
  EXPECT_GT(turn(p, 0.9, 0.2, 0.5), 0);
}

TEST(Turn, IsZeroBySymmetry) {
  const Params p;
  for (const double t : {-1e6, -0.3, 0.0, 0.4, 1e6}) EXPECT_EQ(turn(p, 0.3, t, t), 0);
  EXPECT_EQ(turn(p, p.preferred_temperature, 0.2, 0.9),
            0);  // content: no preference for either side
}

TEST(Turn, IsOddInTheSides) {
  const Params p;
  EXPECT_DOUBLE_EQ(turn(p, 0.55, 0.45, 0.41), -turn(p, 0.55, 0.41, 0.45));
}

TEST(Turn, FollowsTheFormula) {
  Params p;
  p.steering_gain = 3;
  const double tb = 0.55, left = 0.5, right = 0.3;
  const double sl = 1 / (1 + std::exp(-p.sensitivity * left * (p.preferred_temperature - tb)));
  const double sr = 1 / (1 + std::exp(-p.sensitivity * right * (p.preferred_temperature - tb)));
  EXPECT_NEAR(turn(p, tb, left, right), std::atan(p.steering_gain * (sl - sr) / (sl + sr)), 1e-15);
}

TEST(Turn, IsFiniteWhateverTheSettings) {
  Params p;
  for (const double sigma : {-1e6, -1.0, 0.0, 1.0, 1e6, 1e300}) {
    for (const double v : {0.0, 1.0, 1e6, 1e300}) {
      for (const double tp : {-1e6, 0.6, 1e6}) {
        for (const double tb : {-1e6, 0.0, 0.6, 1e6}) {
          for (const double tl : {-1e6, 0.0, 0.5, 1e6}) {
            for (const double tr : {-1e6, 0.1, 1e6}) {
              p.sensitivity = sigma;
              p.steering_gain = v;
              p.preferred_temperature = tp;
              const double delta = turn(p, tb, tl, tr);
              ASSERT_TRUE(std::isfinite(delta)) << sigma << ' ' << v << ' ' << tp << ' ' << tb;
              ASSERT_LE(std::abs(delta), kPi / 2);
            }
          }
        }
      }
    }
  }
}

// Exponents beyond the range of double, by hand. The pup is hot, T_p - T_b = -1, and sigma = 1e300.
TEST(Turn, ComparesTheSidesWhereBothExponentsOverflow) {
  Params p;
  p.sensitivity = 1e300;
  p.steering_gain = 3;
  p.preferred_temperature = 0;
  // S_L = e^-5e308, S_R = e^-4e308: the right side is infinitely better.
  EXPECT_DOUBLE_EQ(turn(p, 1, 5e8, 4e8), -std::atan(3.0));
  EXPECT_DOUBLE_EQ(turn(p, 1, 4e8, 5e8), std::atan(3.0));
  EXPECT_EQ(turn(p, 1, 5e8, 5e8), 0);
  EXPECT_DOUBLE_EQ(turn(p, 1, 1.7e308, 0.1), -std::atan(3.0));
  EXPECT_DOUBLE_EQ(turn(p, 1, 1.7e308, -1.7e308), -std::atan(3.0));  // S_R = 1
  EXPECT_DOUBLE_EQ(turn(p, 1.7e308, 0.5, 0.4), -std::atan(3.0));
  // Cold, both sensors read 1, and the turn is e^-4e308: no double but 0.
  EXPECT_EQ(turn(p, -1, 5e8, 4e8), 0);
}

// sigma = 1e16 and T_L - T_R = 2^-52: the exponents differ by d = 2.22, less than they are known
// to.
TEST(Turn, SeesADifferenceThatRoundingOfTheExponentsHides) {
  Params p;
  p.sensitivity = 1e16;
  p.steering_gain = 1;
  p.preferred_temperature = 0;
  const double d = 1e16 * 0x1p-52;
  EXPECT_NEAR(turn(p, 1, 1 + 0x1p-52, 1), -std::atan(std::tanh(d / 2)), 1e-15);
}

// sigma T is 1e310 or 1e-330, but times T_p - T_b the exponents are 2 and 1.
TEST(Turn, ExponentsMayOverflowOrVanishOnTheWay) {
  Params p;
  p.steering_gain = 3;
  p.preferred_temperature = 0;
  const double sl = 1 / (1 + std::exp(-2.0)), sr = 1 / (1 + std::exp(-1.0));
  const double expected = std::atan(3 * (sl - sr) / (sl + sr));
  p.sensitivity = -1e300;
  EXPECT_NEAR(turn(p, 1e-307, 2e7, 1e7), expected, 1e-12);
  p.sensitivity = -1e-300;
  EXPECT_NEAR(turn(p, 1e307, 2e-7, 1e-7), expected, 1e-12);
  // T_p - T_b = 3.2e308.
  p.preferred_temperature = 1.6e308;
  p.sensitivity = 1 / 1.6e308;
  EXPECT_NEAR(turn(p, -1.6e308, 1, 0.5), expected, 1e-12);
}

/// One pup at rest round (1, 2, 3), of whose points those with x > 1 touch pup 0 (itself: any
/// index).
struct SidesFixture : ::testing::Test {
  SidesFixture()
      : rest(cube_sphere(7, 0.25)),
        cloud(make_cloud<double>(rest)),
        state(make_state<double>(2, 294)) {
    for (int i = 0; i < state.points; ++i) {
      state.x[i] = 1 + rest[i].x();
      state.y[i] = 2 + rest[i].y();
      state.z[i] = 3 + rest[i].z();
      if (rest[i].x() > 0.01) touch(i);
    }
    state.tb[1] = 0.9;
  }
  /// Lets point `i` of pup 0 touch pup 1.
  void touch(int i) {
    state.touched[i] = 1;
    state.touching_points[i / 64] |= std::uint64_t{1} << (i % 64);
  }
  /// Turns the body out of its rest orientation, about an axis of no symmetry.
  void turn_body(double angle) {
    const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3.5).normalized();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    for (int i = 0; i < state.points; ++i) {
      const Eigen::Vector3d p = turn * rest[i];
      state.x[i] = 1 + p.x();
      state.y[i] = 2 + p.y();
      state.z[i] = 3 + p.z();
    }
  }
  std::vector<Eigen::Vector3d> rest;
  Cloud<double> cloud;
  State<double> state;
  Params params;
};

TEST_F(SidesFixture, LeftIsCounterClockwiseOfTheHeading) {
  // Facing -y, the contacts at +x are on the left; facing +y, on the right.
  const SideTemperatures down = side_temperatures(params, cloud, state, 0, -kPi / 2);
  EXPECT_GT(down.left, params.ambient_temperature + 0.3);
  EXPECT_EQ(down.right, params.ambient_temperature);
  const SideTemperatures up = side_temperatures(params, cloud, state, 0, kPi / 2);
  EXPECT_EQ(up.left, params.ambient_temperature);
  EXPECT_GT(up.right, params.ambient_temperature + 0.3);
}

TEST_F(SidesFixture, MeansAreOverAllPointsOfASide) {
  turn_body(0.4);  // so that no point lies on the dividing line
  const double direction = -1.3;
  double sum = 0;
  int left = 0;
  for (int i = 0; i < state.points; ++i) {
    if (std::cos(direction) * (state.y[i] - 2) - std::sin(direction) * (state.x[i] - 1) <= 0)
      continue;
    sum += state.touched[i] >= 0 ? 0.9 : params.ambient_temperature;
    ++left;
  }
  EXPECT_NEAR(side_temperatures(params, cloud, state, 0, direction).left, sum / left, 1e-12);
}

TEST_F(SidesFixture, AboutItsOwnAxisTheFirstPointIsOnNoSide) {
  // It lies on the axis, where rounding alone would decide; the rule says: not on the left.
  std::fill(state.touched.begin(), state.touched.end(), -1);
  std::fill(state.touching_points.begin(), state.touching_points.end(), 0);
  touch(0);
  for (const double angle : {0.1, 0.9, 2.2, -1.4}) {
    turn_body(angle);
    const SideTemperatures t = body_side_temperatures(params, cloud, state, 0);
    EXPECT_EQ(t.left, params.ambient_temperature);
    EXPECT_GT(t.right, params.ambient_temperature);
  }
}

TEST_F(SidesFixture, TemperaturesMayAddUpToMoreThanADoubleHolds) {
  turn_body(0.4);  // so that no point lies on the dividing line
  state.tb[1] = 1.5e308;
  params.ambient_temperature = -1.5e308;
  int touching = 0, right = 0;
  for (int i = 0; i < state.points; ++i) {
    if (state.x[i] <= 1) continue;
    ++right;
    touching += state.touched[i] == 1 ? 1 : 0;
  }
  ASSERT_LT(touching, right);
  // The touching share of the right side's points goes 3e308 up from T_a.
  const double expected = -1.5 + 3.0 * touching / right;
  EXPECT_NEAR(side_temperatures(params, cloud, state, 0, kPi / 2).right / 1e308, expected, 1e-12);
}

TEST_F(SidesFixture, BodyAxisPointsFromTheFirstPointToTheCentre) {
  EXPECT_NEAR(body_axis(cloud, state, 0), std::atan2(-rest[0].y(), -rest[0].x()), 1e-12);
}

TEST_F(SidesFixture, CourseTurnsAtARateAndBodyHeadingJumps) {
  state.exposed[0] = 0.5;
  state.tb[0] = 0.9;  // hot: away from the contacts on the left
  state.heading[0] = -kPi / 2;
  const SideTemperatures t = side_temperatures(params, cloud, state, 0, -kPi / 2);
  const double delta = turn(params, 0.9, t.left, t.right);
  ASSERT_LT(delta, 0);
  steer(params, {}, cloud, state, 0);
  EXPECT_NEAR(state.heading[0], -kPi / 2 + params.dt * delta, 1e-15);

  params.heading = Heading::body;
  const double axis = body_axis(cloud, state, 0);
  const SideTemperatures about_axis = body_side_temperatures(params, cloud, state, 0);
  steer(params, {}, cloud, state, 0);
  EXPECT_NEAR(state.heading[0],
              wrap_angle(axis + turn(params, 0.9, about_axis.left, about_axis.right)), 1e-15);
}

}  // namespace
}  // namespace pupflow
