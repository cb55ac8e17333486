#include "app/view/afferent_map.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "pupflow/geometry.h"
#include "pupflow/simulation.h"
#include "pupflow/skin.h"

namespace pupflow::view {
namespace {

constexpr double kPi = std::numbers::pi;
using Vector = Eigen::Vector3d;

Eigen::Matrix3d any_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

TEST(AfferentMap, TheCrossHasACellForEachAfferentAndNoneOverlap) {
  for (const int k : {2, 3, 7, 11}) {
    const SkinCross cross(k);
    const std::vector<Eigen::Vector2d>& cells = cross.cells();
    ASSERT_EQ(cells.size(), skin_cells(k).size());
    std::set<std::pair<long, long>> places;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Eigen::Vector2d place = k * cells[i];
      EXPECT_NEAR((place - place.array().round().matrix()).norm(), 0, 1e-9) << "on a grid";
      places.emplace(std::lround(place.x()), std::lround(place.y()));
      const Eigen::Vector2d middle = cells[i] + Eigen::Vector2d::Constant(0.5 / k);
      EXPECT_EQ(cross.afferent(middle), static_cast<int>(i));
      const CrossFace& face = kCross[i / static_cast<std::size_t>(k * k)];
      EXPECT_TRUE(middle.x() > face.x && middle.x() < face.x + 1) << i;
      EXPECT_TRUE(middle.y() > face.y && middle.y() < face.y + 1) << i;
    }
    EXPECT_EQ(places.size(), cells.size());
  }
  EXPECT_EQ(SkinCross(7).afferent({0.5, 0.5}), -1) << "beside the cross";
  EXPECT_EQ(SkinCross(7).afferent({-0.1, 1.5}), -1);
  EXPECT_EQ(SkinCross(7).afferent({4.1, 1.5}), -1);
  EXPECT_EQ(SkinCross(7).afferent({std::nan(""), 1.5}), -1);
}

TEST(AfferentMap, NeighboursOnTheCrossAreNeighboursOnTheSkin) {
  constexpr int k = 7;
  const SkinCross cross(k);
  const std::vector<Eigen::Vector2d>& cells = cross.cells();
  const std::vector<Vector> rest = cube_sphere(k, 1);
  int neighbours = 0;
  for (std::size_t a = 0; a < cells.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if ((cells[a] - cells[b]).norm() * k > 1.01) continue;
      ++neighbours;
      EXPECT_LT((rest[a] - rest[b]).norm(), 0.35) << a << ' ' << b;
    }
  }
  EXPECT_EQ(neighbours, 6 * 2 * k * (k - 1) + 5 * k) << "within the faces, and across five edges";
}

TEST(AfferentMap, TheCrossIsSeenFromOutside) {
  constexpr int k = 5;
  const SkinCross cross(k);
  const std::vector<Eigen::Vector2d>& cells = cross.cells();
  const std::vector<Vector> rest = cube_sphere(k, 1);
  const std::vector<SkinCell> skin = skin_cells(k);
  for (std::size_t i = 0; i + 1 < skin.size(); ++i) {
    if (skin[i].row + 1 == k || skin[i].column + 1 == k) continue;
    const Vector row = rest[i + k] - rest[i], column = rest[i + 1] - rest[i];
    const Eigen::Vector2d flat_row = cells[i + k] - cells[i], flat_column = cells[i + 1] - cells[i];
    const double outward = row.cross(column).dot(rest[i]);
    const double upward = flat_row.x() * -flat_column.y() + flat_row.y() * flat_column.x();
    EXPECT_GT(outward * upward, 0) << i;
  }
}

TEST(AfferentMap, EachAfferentHasTheDirectionsRoundItsOwn) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (const int k : {2, 3, 7, 32}) {
    const std::vector<Vector> rest = cube_sphere(k, 0.25);
    for (std::size_t i = 0; i < rest.size(); ++i) {
      EXPECT_EQ(afferent_towards(rest[i].normalized(), k), static_cast<int>(i));
    }
    const double far = 0.25 * 1.7 / k;  // half the diagonal of a cell, and some more
    for (int i = 0; i < 2000; ++i) {
      const Vector direction = Vector(normal(random), normal(random), normal(random)).normalized();
      const auto found = static_cast<std::size_t>(afferent_towards(direction, k));
      ASSERT_LT(found, rest.size());
      EXPECT_LT((0.25 * direction - rest[found]).norm(), far) << k;
    }
  }
  EXPECT_GE(afferent_towards(Vector(1, 1, 1).normalized(), 7), 0) << "a corner of the cube";
  EXPECT_GE(afferent_towards(Vector(-1, -1, 1).normalized(), 7), 0);
}

TEST(AfferentMap, EveryAfferentHasItsEqualShareOfTheDisc) {
  std::mt19937 random(1);
  for (const int k : {2, 4, 7}) {
    for (int turn = 0; turn < 10; ++turn) {
      HeadingDisc disc(k, 400);
      disc.update(any_rotation(random), 0.1 * turn);
      std::vector<int> pixels(skin_cells(k).size());
      int inside = 0;
      for (const int afferent : disc.afferents()) {
        if (afferent < 0) continue;
        ++pixels[static_cast<std::size_t>(afferent)];
        ++inside;
      }
      EXPECT_NEAR(inside, kPi / 4 * 400 * 400, 0.002 * 400 * 400);
      const auto [least, most] = std::minmax_element(pixels.begin(), pixels.end());
      const double mean = inside / static_cast<double>(pixels.size());
      EXPECT_GT(*least, 0.65 * mean) << k;
      EXPECT_LT(*most, 1.2 * mean) << k;
    }
  }
}

TEST(AfferentMap, AfferentsAreOnTheDiscWhereTheyLookTo) {
  std::mt19937 random(2);
  constexpr int k = 7, kSize = 301;
  const std::vector<Vector> rest = cube_sphere(k, 1);
  HeadingDisc disc(k, kSize);
  for (int turn = 0; turn < 20; ++turn) {
    const Eigen::Matrix3d rotation = any_rotation(random);
    const double heading = 0.3 * turn - 3;
    disc.update(rotation, heading);
    const Vector ahead(std::cos(heading), std::sin(heading), 0), left(-ahead.y(), ahead.x(), 0);
    for (std::size_t i = 0; i < rest.size(); ++i) {
      const Vector direction = rotation * rest[i];
      const double angle = std::acos(std::clamp(direction.dot(ahead), -1.0, 1.0));
      if (angle > 0.9 * kPi) continue;  // next to the rim cells are thinner than pixels
      Eigen::Vector2d place(-direction.dot(left), -direction.z());
      place *= std::sin(angle / 2) / std::max(place.norm(), 1e-9);
      const auto column = static_cast<int>((1 + place.x()) / 2 * kSize);
      const auto row = static_cast<int>((1 + place.y()) / 2 * kSize);
      EXPECT_EQ(disc.afferents()[static_cast<std::size_t>(row * kSize + column)],
                static_cast<int>(i));
    }
    EXPECT_EQ(disc.afferents().front(), -1) << "a corner is outside";
  }
}

TEST(AfferentMap, LeftOnTheDiscIsWhatSteeringCallsLeft) {
  Params params;
  params.pups = 4;
  params.arena_radius = 0.9;
  Simulation simulation(params);
  simulation.set_observed({Part::sides});
  simulation.run(100);
  const LitterView litter = simulation.view();
  ASSERT_FALSE(litter.left.empty());
  int agreed = 0, counted = 0;
  constexpr int kSize = 100;
  HeadingDisc disc(params.face_points, kSize);
  for (int pup = 0; pup < litter.pups; ++pup) {
    disc.update(body_rotation(litter, pup), litter.heading[static_cast<std::size_t>(pup)]);
    for (int pixel = 0; pixel < kSize * kSize; ++pixel) {
      const int afferent = disc.afferents()[static_cast<std::size_t>(pixel)];
      const int from_middle = pixel % kSize - kSize / 2;
      // The sides were told apart before the last turn.
      if (afferent < 0 || std::abs(from_middle) < kSize / 12) continue;
      const auto at = static_cast<std::size_t>(pup * litter.points + afferent);
      agreed += (from_middle < 0) == (litter.left[at] != 0) ? 1 : 0;
      ++counted;
    }
  }
  EXPECT_GT(counted, 1000);
  EXPECT_GT(agreed, 0.995 * counted);
}

TEST(AfferentMap, TheRotationOfABodyIsFoundAndOneWithBadNumbersHasNone) {
  std::mt19937 random(3);
  Params params;
  params.pups = 1;
  Simulation simulation(params);
  const std::vector<Vector> rest = cube_sphere(params.face_points, params.pup_radius);
  const Eigen::Matrix3d rotation = any_rotation(random);
  std::vector<double> xyz, still(3 * rest.size());
  for (const Vector& q : rest) {
    const Vector place = Vector(0.3, -0.2, 0.5) + rotation * q;
    xyz.insert(xyz.end(), place.data(), place.data() + 3);
  }
  simulation.set_cloud(0, xyz, still);
  EXPECT_LT((body_rotation(simulation, 0) - rotation).norm(), 1e-5);
  xyz[5] = std::nan("");
  simulation.set_cloud(0, xyz, still);
  EXPECT_EQ(body_rotation(simulation, 0), Eigen::Matrix3d::Identity());
}

}  // namespace
}  // namespace pupflow::view
