#include "app/view/light.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace pupflow::view {
namespace {

using Vector = Eigen::Vector3f;

constexpr float kDegrees = std::numbers::pi_v<float> / 180;

float open_light(const Vector& normal) {
  const Ball ball{{0, 0, 2}, 0.3f};
  return Light(std::span(&ball, 1), true).at(0, ball.centre + 0.3f * normal, normal);
}

TEST(Light, IsFullWithin35DegreesOfTheLamp) {
  const Vector lamp = key_light();
  EXPECT_NEAR(lamp.norm(), 1, 1e-6);
  const Vector across = lamp.unitOrthogonal();
  for (float around = 0; around < 360; around += 15) {
    const Vector axis = Eigen::AngleAxisf(around * kDegrees, lamp) * across;
    for (const float away : {0.0f, 20.0f, 34.5f}) {
      EXPECT_EQ(open_light(Eigen::AngleAxisf(away * kDegrees, axis) * lamp), 1) << around;
    }
  }
}

TEST(Light, FallsOffAwayFromTheLampAndBelow) {
  const Vector side = key_light().cross(Vector::UnitZ()).normalized();
  EXPECT_LT(open_light(side), 0.95f);
  EXPECT_LT(open_light(-key_light()), open_light(side));
  EXPECT_GT(open_light(-key_light()), 0.2f);
}

TEST(Light, IsTakenByNeighboursOnly) {
  const Vector sideways(1, 0, 0);
  const Ball own{{0, 0, 0.3f}, 0.3f};
  const auto towards = [&](float distance) {
    const Ball balls[] = {own, {{distance, 0, 0.3f}, 0.3f}};
    return Light(balls, true).at(0, own.centre + 0.3f * sideways, sideways);
  };
  const float alone = Light(std::span(&own, 1), true).at(0, {0.3f, 0, 0.3f}, sideways);
  EXPECT_LT(towards(0.6f), 0.7f * alone);
  EXPECT_LT(towards(0.6f), towards(0.8f));
  EXPECT_LT(towards(0.8f), alone);
  EXPECT_EQ(towards(2), alone);
  const Ball balls[] = {own, {{0.6f, 0, 0.3f}, 0.3f}};
  EXPECT_EQ(Light(balls, false).at(0, {0.3f, 0, 0.3f}, sideways), alone);
}

TEST(Light, EachBodyFindsAllItsNeighbours) {
  // Many along one line and across it; the one in the middle is darkened by both its neighbours.
  std::vector<Ball> balls;
  for (int i = 0; i < 60; ++i) {
    balls.push_back(
        {{0.6f * static_cast<float>(i % 10), 0.6f * static_cast<float>(i / 10), 0.3f}, 0.3f});
  }
  const Light light(balls, true);
  for (const Vector& way : {Vector(1, 0, 0), Vector(-1, 0, 0), Vector(0, 1, 0), Vector(0, -1, 0)}) {
    const Ball& own = balls[25];
    const float alone = Light(std::span(&own, 1), true).at(0, own.centre + 0.3f * way, way);
    EXPECT_LT(light.at(25, own.centre + 0.3f * way, way), 0.75f * alone);
  }
}

TEST(Light, OnTheFloorIsDarkBelowABodyAndBehindIt) {
  const Ball ball{{0.2f, -0.1f, 0.3f}, 0.3f};
  FloorLight floor;
  Light(std::span(&ball, 1), true).on_floor(2, 0.01f, floor);
  ASSERT_GT(floor.size, 16);
  ASSERT_EQ(floor.texels.size(), static_cast<std::size_t>(floor.size) * floor.size);
  const auto at = [&](float x, float y) {
    const auto texel = [&](float place) {
      return static_cast<int>((place + 2) / 4 * static_cast<float>(floor.size));
    };
    return int{floor.texels[static_cast<std::size_t>(texel(y) * floor.size + texel(x))]};
  };
  const Eigen::Vector2f away = -key_light().head<2>().normalized();
  EXPECT_EQ(at(-1.5f, 1.5f), 255);
  EXPECT_LT(at(0.2f, -0.1f), 120);
  EXPECT_LT(at(0.2f + 0.4f * away.x(), -0.1f + 0.4f * away.y()),
            at(0.2f - 0.4f * away.x(), -0.1f - 0.4f * away.y()) - 20);
}

}  // namespace
}  // namespace pupflow::view
