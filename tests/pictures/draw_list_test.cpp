#include "app/view/draw_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "pupflow/simulation.h"

namespace pupflow::view {
namespace {

const ColorScale kScale("viridis", 0, 1);

TEST(DrawList, HoldsEveryPointInItsPupsColor) {
  Params params;
  params.pups = 2;
  Simulation simulation(params);
  simulation.set_body_temperature(0, 0.1);
  simulation.set_body_temperature(1, 0.9);
  DrawList list;
  list.update(simulation, kScale, Camera::parse("top"), Culling::none);

  std::vector<float> positions(2 * 294 * 3);
  simulation.view().positions.copy_to(positions);
  ASSERT_EQ(list.spheres().size(), 2u * 294u);
  for (std::size_t i = 0; i < list.spheres().size(); ++i) {
    const Sphere& sphere = list.spheres()[i];
    EXPECT_EQ(sphere.x, positions[3 * i]);
    EXPECT_EQ(sphere.y, positions[3 * i + 1]);
    EXPECT_EQ(sphere.z, positions[3 * i + 2]);
    EXPECT_EQ((Rgb{sphere.r, sphere.g, sphere.b}), kScale(i < 294 ? 0.1 : 0.9));
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
    list.update(simulation, ColorScale(field), Camera::parse("top"), Culling::none);
    const ColorScale& scale = list.scale();
    EXPECT_TRUE(scale.is_fitted()) << name;
    EXPECT_FALSE(scale.unknown) << name;
    ASSERT_EQ(list.spheres().size(), 4u * 294u);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < list.spheres().size(); ++i) {
      const Sphere& sphere = list.spheres()[i];
      const Rgb expected = scale(values[field.of_afferents ? i : i / 294]);
      wrong += (Rgb{sphere.r, sphere.g, sphere.b}) != expected;
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
  list.update(simulation, ColorScale(field), Camera::parse("top"));
  EXPECT_TRUE(list.scale().unknown);
  const Sphere& sphere = list.spheres().front();
  EXPECT_EQ((Rgb{sphere.r, sphere.g, sphere.b}), kUnknownColor);
}

TEST(DrawList, LeavesOutOnlyPointsThatFaceAway) {
  Params params;
  params.pups = 1;
  const Simulation simulation(params);
  const Eigen::Vector3d centre = simulation.view().positions.mean(0);
  const Camera top = Camera::parse("top");
  DrawList all, visible;
  all.update(simulation, kScale, top, Culling::none);
  visible.update(simulation, kScale, top, Culling::hidden);
  EXPECT_LT(10 * visible.spheres().size(), 8 * all.spheres().size());
  std::size_t near_side = 0;
  for (const Sphere& sphere : all.spheres()) near_side += sphere.z > centre.z() - 0.05;
  std::size_t kept = 0;
  for (const Sphere& sphere : visible.spheres()) kept += sphere.z > centre.z() - 0.05;
  EXPECT_EQ(kept, near_side);
  EXPECT_EQ(visible.bounds().low, all.bounds().low);
  EXPECT_EQ(visible.bounds().high, all.bounds().high);
}

TEST(DrawList, KeepsAllPointsOfAnOpenSkin) {
  Params params;
  params.face_points = 3;  // gaps wider than a point
  const Simulation simulation(params);
  DrawList list;
  list.update(simulation, kScale, Camera::parse("top"));
  EXPECT_EQ(list.spheres().size(), static_cast<std::size_t>(12 * 54));
}

TEST(DrawList, KeepsAllPointsAroundTheEye) {
  Params params;
  params.pups = 1;
  params.start_spread = 0;
  const Simulation simulation(params);  // its centre is 0.3 above the floor
  DrawList list;
  list.update(simulation, kScale, Camera::parse("orbit:0,90,0.3"));
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
  EXPECT_TRUE(list.bounds().high.allFinite());
}

}  // namespace
}  // namespace pupflow::view
