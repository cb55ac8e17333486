#include "app/view/draw_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "pupflow/simulation.h"

namespace pupflow::view {
namespace {

const ColorScale kScale("viridis", 0, 1);

/// All points as spheres in the colors of the scale: without light.
constexpr Drawing kAll{.draw = Draw::points, .culling = Culling::none};
constexpr Drawing kVisible{.draw = Draw::points};

/// Whether `seen` is `color` under some light.
bool is_lit(const Vertex& seen, Rgb color) {
  const double light = (1.0 * seen.r + seen.g + seen.b) / std::max(1, color.r + color.g + color.b);
  const auto near = [&](int a, int b) { return std::abs(a - light * b) <= 1.5; };
  return light > 0.05 && light < 1.01 && near(seen.r, color.r) && near(seen.g, color.g) &&
         near(seen.b, color.b);
}

TEST(DrawList, HoldsEveryPointInItsPupsColor) {
  Params params;
  params.pups = 2;
  Simulation simulation(params);
  simulation.set_body_temperature(0, 0.1);
  simulation.set_body_temperature(1, 0.9);
  DrawList list;
  list.update(simulation, kScale, Camera::parse("top"), kAll);

  std::vector<float> positions(2 * 294 * 3);
  simulation.view().positions.copy_to(positions);
  ASSERT_EQ(list.spheres().size(), 2u * 294u);
  for (std::size_t i = 0; i < list.spheres().size(); ++i) {
    const Vertex& sphere = list.spheres()[i];
    EXPECT_EQ(sphere.x, positions[3 * i]);
    EXPECT_EQ(sphere.y, positions[3 * i + 1]);
    EXPECT_EQ(sphere.z, positions[3 * i + 2]);
    EXPECT_TRUE(is_lit(sphere, kScale(i < 294 ? 0.1 : 0.9))) << i;
  }
  EXPECT_EQ(list.sphere_radius(), 0.05f);
  EXPECT_EQ(list.arena_radius(), 2.0f);
}

/// A huddle that records what `field` needs.
Simulation huddle(const LitterField& field) {
  Params params;
  params.pups = 4;
  params.arena_radius = 0.9;
  Simulation simulation(params);
  simulation.set_observed(field.parts);
  simulation.run(30);
  return simulation;
}

TEST(DrawList, GivesEachPupOrPointTheColorOfItsValue) {
  for (const char* name : {"deformation", "turn", "heading", "group",  // of pups
                           "temperature", "strain", "normal_z", "touched", "side"}) {
    const LitterField& field = *find_field(name);
    const Simulation simulation = huddle(field);
    const std::vector<double> values = field.values(simulation);
    DrawList list;
    list.update(simulation, ColorScale(field), Camera::parse("top"), kAll);
    const ColorScale& scale = list.scale();
    EXPECT_TRUE(scale.is_fitted()) << name;
    EXPECT_FALSE(scale.unknown) << name;
    ASSERT_EQ(list.spheres().size(), 4u * 294u);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < list.spheres().size(); ++i) {
      const Vertex& sphere = list.spheres()[i];
      wrong += !is_lit(sphere, scale(values[field.of_afferents ? i : i / 294]));
    }
    EXPECT_EQ(wrong, 0u) << name;
  }
}

TEST(DrawList, GivesValuesThatWereNotRecordedGray) {
  const LitterField& field = *find_field("strain");
  Params params;
  params.pups = 1;
  Simulation simulation(params);
  simulation.set_observed({});
  simulation.step();
  DrawList list;
  list.update(simulation, ColorScale(field), Camera::parse("top"), kVisible);
  EXPECT_TRUE(list.scale().unknown);
  EXPECT_TRUE(is_lit(list.spheres().front(), kUnknownColor));
}

TEST(DrawList, LeavesOutOnlyPointsThatFaceAway) {
  Params params;
  params.pups = 1;
  const Simulation simulation(params);
  const Eigen::Vector3d centre = simulation.view().positions.mean(0);
  const Camera top = Camera::parse("top");
  DrawList all, visible;
  all.update(simulation, kScale, top, kAll);
  visible.update(simulation, kScale, top, kVisible);
  EXPECT_LT(10 * visible.spheres().size(), 8 * all.spheres().size());
  std::size_t near_side = 0;
  for (const Vertex& sphere : all.spheres()) near_side += sphere.z > centre.z() - 0.05;
  std::size_t kept = 0;
  for (const Vertex& sphere : visible.spheres()) kept += sphere.z > centre.z() - 0.05;
  EXPECT_EQ(kept, near_side);
  EXPECT_EQ(visible.bounds().low, all.bounds().low);
  EXPECT_EQ(visible.bounds().high, all.bounds().high);
}

TEST(DrawList, KeepsAllPointsOfAnOpenSkin) {
  Params params;
  params.face_points = 3;  // gaps wider than a point
  const Simulation simulation(params);
  DrawList list;
  list.update(simulation, kScale, Camera::parse("top"), kVisible);
  EXPECT_EQ(list.spheres().size(), static_cast<std::size_t>(12 * 54));
}

TEST(DrawList, KeepsAllPointsAroundTheEye) {
  Params params;
  params.pups = 1;
  params.start_spread = 0;
  const Simulation simulation(params);  // its centre is 0.3 above the floor
  DrawList list;
  list.update(simulation, kScale, Camera::parse("orbit:0,90,0.3"), kVisible);
  EXPECT_EQ(list.spheres().size(), 294u);
}

TEST(DrawList, NoPupsAndBadNumbersLeaveTheArena) {
  Params params;
  params.pups = 0;
  DrawList list;
  list.update(Simulation(params), kScale, Camera::parse("top"));
  EXPECT_TRUE(list.spheres().empty());
  EXPECT_GT(list.bounds().high.x(), 2);

  params.pups = 1;
  Simulation broken(params);
  const std::vector<double> nothing(3 * 294, std::numeric_limits<double>::quiet_NaN());
  broken.set_cloud(0, nothing, nothing);
  list.update(broken, kScale, Camera::parse("top"));
  EXPECT_TRUE(list.spheres().empty());
  EXPECT_TRUE(list.skin().indices.empty());
  EXPECT_TRUE(list.bounds().high.allFinite());
}

TEST(DrawList, TheSkinIsOnePointRadiusOutsideThePoints) {
  Params params;
  params.pups = 1;
  const Simulation simulation(params);
  const Eigen::Vector3d centre = simulation.view().positions.mean(0);
  DrawList list;
  list.update(simulation, kScale, Camera::parse("top"), {.quality = Quality::fast});
  EXPECT_TRUE(list.spheres().empty());
  EXPECT_TRUE(list.outline().indices.empty());
  ASSERT_FALSE(list.skin().indices.empty());
  for (const Vertex& vertex : list.skin().vertices) {
    const double away = (Eigen::Vector3d(vertex.x, vertex.y, vertex.z) - centre).norm();
    EXPECT_NEAR(away, params.pup_radius + params.point_radius, 0.01);
  }
}

TEST(DrawList, BothHasSkinAndPoints) {
  const Simulation simulation{Params()};
  DrawList list;
  list.update(simulation, kScale, Camera::parse("top"), {.draw = Draw::both});
  EXPECT_FALSE(list.spheres().empty());
  EXPECT_FALSE(list.skin().indices.empty());
}

TEST(DrawList, ASmallPictureTakesFewerTriangles) {
  Params params;
  params.pups = 1;
  const Simulation simulation(params);
  const auto triangles = [&](int rows) {
    DrawList list;
    list.update(simulation, kScale, Camera::parse("orbit:30,35,10"), {.rows = rows});
    return list.skin().indices.size() / 3;
  };
  EXPECT_EQ(triangles(40), 0u);  // an ellipsoid
  EXPECT_GT(triangles(240), 0u);
  EXPECT_LT(triangles(240), triangles(480));
  EXPECT_LT(triangles(480), triangles(4000));
  EXPECT_LE(triangles(1 << 20), 584u * 64u);
}

TEST(DrawList, ASmallBodyIsOneEllipsoidOfItsAxes) {
  Params params;
  params.pups = 1;
  Simulation simulation(params);
  const Eigen::Vector3d centre = simulation.view().positions.mean(0);
  const Eigen::Vector3d stretch(1.5, 1, 0.6);
  std::vector<double> cloud;
  for (int i = 0; i < simulation.points(); ++i) {
    const Eigen::Vector3d place = simulation.view().positions(0, i);
    for (const int axis : {0, 1, 2}) {
      cloud.push_back(centre[axis] + stretch[axis] * (place - centre)[axis]);
    }
  }
  simulation.set_cloud(0, cloud, std::vector<double>(cloud.size(), 0.0));
  DrawList list;
  list.update(simulation, kScale, Camera::parse("top"), {.rows = 40});
  EXPECT_TRUE(list.skin().indices.empty());
  EXPECT_TRUE(list.outline().indices.empty());
  ASSERT_EQ(list.ellipsoids().size(), 1u);
  const Ellipsoid& body = list.ellipsoids()[0];
  for (const int axis : {0, 1, 2}) {
    EXPECT_NEAR(body.centre[axis], centre[axis], 1e-5);
    EXPECT_NEAR(body.shape[axis], params.pup_radius * stretch[axis] + params.point_radius, 2e-3);
    EXPECT_NEAR(body.shape[3 + axis], 0, 2e-3);
  }
  const Rgb color = kScale(simulation.view().tb[0]);
  EXPECT_EQ((Rgb{body.color[0], body.color[1], body.color[2]}), color);
}

TEST(DrawList, PointsAndCellsAreShownInSmallerBodiesThanSkins) {
  const LitterField& field = *find_field("touched");
  const Simulation simulation = huddle(field);
  const auto pups = static_cast<std::size_t>(simulation.pups());
  Camera camera = Camera::parse("top");
  camera.frame(2, 0, 1);
  // A body's diameter is some 0.6 units, and the picture 4 units high.
  const auto ellipsoids = [&](const ColorScale& scale, Draw draw, int rows) {
    DrawList list;
    list.update(simulation, scale, camera, {.draw = draw, .rows = rows});
    return list.ellipsoids().size();
  };
  EXPECT_EQ(ellipsoids(kScale, Draw::skin, 120), pups);
  for (const Draw draw : {Draw::points, Draw::both}) {
    EXPECT_EQ(ellipsoids(kScale, draw, 120), 0u);
    EXPECT_EQ(ellipsoids(kScale, draw, 50), pups);
  }
  EXPECT_EQ(ellipsoids(ColorScale(field), Draw::skin, 120), 0u);
  EXPECT_EQ(ellipsoids(ColorScale(field), Draw::skin, 50), pups);
}

TEST(DrawList, AfferentsOnTheSkinHaveCellsOfTheirOwnColor) {
  const LitterField& field = *find_field("touched");
  const Simulation simulation = huddle(field);
  const std::vector<double> values = field.values(simulation);
  DrawList list;
  list.update(simulation, ColorScale(field), Camera::parse("top"));
  for (const Vertex& vertex : list.skin().vertices) {
    const bool known = std::ranges::any_of(
        values, [&](double value) { return is_lit(vertex, list.scale()(value)); });
    ASSERT_TRUE(known) << int{vertex.r} << " " << int{vertex.g} << " " << int{vertex.b};
  }
}

TEST(DrawList, WhatIsOffIsNotMade) {
  const Simulation simulation{Params()};
  DrawList list;
  list.update(simulation, kScale, Camera::parse("top"), {.quality = Quality::normal});
  EXPECT_GT(list.floor().size, 0);
  EXPECT_FALSE(list.outline().indices.empty());
  list.update(simulation, kScale, Camera::parse("top"), {.quality = Quality::fast});
  EXPECT_EQ(list.floor().size, 0);
  EXPECT_TRUE(list.outline().indices.empty());
}

TEST(DrawList, HoldsNothingOfWhatIsBehindTheEyeOrFarBelowTheView) {
  Params params;
  params.pups = 2;
  Simulation simulation(params);
  std::vector<double> both_clouds(2 * 3 * 294);
  simulation.view().positions.copy_to(both_clouds);
  const std::vector<double> cloud(both_clouds.begin() + 3 * 294, both_clouds.end());
  const std::vector<double> rest(cloud.size(), 0.0);
  const Eigen::Vector3d middle = simulation.view().positions.mean(1);
  const auto count = [&](double forward, double up) {
    const Camera camera = Camera::parse("orbit:0,0,10");
    const Eigen::Vector3d place = camera.eye() - forward * camera.backward() + up * camera.up();
    const Eigen::Vector3d shift = place - middle;
    std::vector<double> moved = cloud;
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += shift[static_cast<int>(i % 3)];
    simulation.set_cloud(1, moved, rest);
    DrawList list;
    list.update(simulation, kScale, camera, kVisible);
    return list.spheres().size();
  };
  const std::size_t both = count(10, 0);
  EXPECT_LT(count(-5, 0), both);
  EXPECT_LT(count(10, -5), both);
  EXPECT_GT(count(0.2, 0), count(-5, 0)) << "beside the eye it may be seen";
}

}  // namespace
}  // namespace pupflow::view
