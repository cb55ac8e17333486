#include "app/view/pick.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "app/view/framing.h"
#include "app/view/marks.h"
#include "app/view/skin_mesh.h"
#include "pupflow/simulation.h"

namespace pupflow::view {
namespace {

using Vector = Eigen::Vector3d;

/// A huddle of seven.
Simulation huddle() {
  Params params;
  params.pups = 7;
  params.arena_radius = 0.9;
  Simulation simulation(params);
  simulation.run(60);
  return simulation;
}

/// Cameras of all kinds: in the usual place, near, far, above, below, in the midst, without
/// perspective.
Camera any_camera(std::mt19937& random, const Params& params, double aspect) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const int kind = std::uniform_int_distribution(0, 9)(random);
  if (kind == 0) return framed(Camera::parse("top"), params, aspect);
  if (kind == 1) return framed(Camera::parse("side"), params, aspect);
  Camera camera = framed(Camera::parse("orbit:30,35"), params, aspect);
  camera.orbit(uniform(-4, 4), uniform(-2, 2));
  camera.zoom(std::exp(uniform(-1, 3)));
  camera.pan(uniform(-0.3, 0.3), uniform(-0.3, 0.3));
  return camera;
}

/// The same answer from every triangle of every pup, each by the solution of three equations.
std::optional<int> pick_by_force(const LitterView& litter, const Ray& ray) {
  const int k = litter.params.face_points;
  const SkinMesh mesh = skin_mesh(k, k);
  std::optional<int> picked;
  double nearest = std::numeric_limits<double>::infinity();
  for (int pup = 0; pup < litter.pups; ++pup) {
    std::vector<float> xyz(static_cast<std::size_t>(3 * litter.points));
    litter.positions.copy_pup_to(pup, xyz);
    SkinShape shape;
    shape.fit(mesh, xyz);
    for (const auto& triangle : mesh.triangles) {
      Vector corner[3];
      for (std::size_t c = 0; c < 3; ++c) {
        const auto v = static_cast<std::size_t>(triangle[c]);
        const auto lift = static_cast<float>(litter.params.point_radius);
        corner[c] = (shape.places[v] + lift * shape.normals[v]).cast<double>();
      }
      Eigen::Matrix3d edges;
      edges << corner[1] - corner[0], corner[2] - corner[0], -ray.along;
      const Vector solution = edges.inverse() * (ray.from - corner[0]);
      const double u = solution.x(), v = solution.y(), distance = solution.z();
      if (!(u >= 0 && v >= 0 && u + v <= 1 && distance >= 0 && distance < nearest)) continue;
      nearest = distance;
      picked = pup;
    }
  }
  return picked;
}

TEST(Pick, TheSightThroughAPlaceOfThePictureGoesThroughWhatIsSeenThere) {
  std::mt19937 random(1);
  Params params;
  const Bounds bounds{Vector(-2, -2, 0), Vector(2, 2, 1)};
  int seen = 0;
  for (int i = 0; i < 400; ++i) {
    const int width = 300 + i, height = 500;
    const double aspect = static_cast<double>(width) / height;
    const Camera camera = any_camera(random, params, aspect);
    const Projection projection(camera, bounds, width, height);
    const Vector place = Vector::Random();
    Eigen::Vector2d pixels;
    if (!projection.place(place, pixels)) continue;
    ++seen;
    const Ray ray = sight(camera, aspect, pixels.x() / width, pixels.y() / height);
    const Vector away = place - ray.from;
    const double along = away.dot(ray.along);
    EXPECT_NEAR(ray.along.norm(), 1, 1e-12);
    EXPECT_GT(along, 0);
    EXPECT_LT((away - along * ray.along).norm(), 1e-4 * std::max(1.0, camera.distance()))
        << camera.spec();
  }
  EXPECT_GT(seen, 200);
}

TEST(Pick, FindsTheSamePupAsATryOfEveryTriangle) {
  const Simulation litter = huddle();
  std::mt19937 random(2);
  std::uniform_real_distribution share(0.0, 1.0);
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    const Camera camera = any_camera(random, litter.params(), 1.3);
    for (int j = 0; j < 5; ++j) {
      const Ray ray = sight(camera, 1.3, share(random), share(random));
      const std::optional<int> expected = pick_by_force(litter, ray);
      EXPECT_EQ(pick(litter, ray), expected) << camera.spec();
      met += expected ? 1 : 0;
    }
  }
  EXPECT_GT(met, 150) << "rays that meet a pup";
  EXPECT_LT(met, 1400) << "rays that meet none";
}

TEST(Pick, TakesTheNearestOfTwoBehindEachOther) {
  Params params;
  params.pups = 2;
  const Simulation litter(params);  // one above the other
  const Vector low = litter.view().positions.mean(0), high = litter.view().positions.mean(1);
  const Vector up = (high - low).normalized();
  EXPECT_EQ(pick(litter, {low - 5 * up, up}), 0);
  EXPECT_EQ(pick(litter, {high + 5 * up, -up}), 1);
  EXPECT_EQ(pick(litter, {high + 5 * up, up}), std::nullopt) << "all is behind";
}

TEST(Pick, APupWithBadNumbersIsWhatIsLeftOfIt) {
  Params params;
  params.pups = 2;
  Simulation litter(params);
  std::vector<double> xyz(static_cast<std::size_t>(3 * litter.points())), still(xyz.size());
  litter.view().positions.copy_pup_to(0, xyz);
  const double radius = params.point_radius;
  const Vector kept(xyz[0], xyz[1], xyz[2]);
  std::fill(xyz.begin() + 3, xyz.end(), std::numeric_limits<double>::quiet_NaN());
  litter.set_cloud(0, xyz, still);
  const Vector along = Vector::UnitX(), far = kept - 5 * along;
  EXPECT_EQ(pick(litter, {far, along}), 0);
  EXPECT_EQ(pick(litter, {far + Vector(0, 0.9 * radius, 0), along}), 0);
  EXPECT_EQ(pick(litter, {far + Vector(0, 1.1 * radius, 0), along}), std::nullopt);
  std::fill(xyz.begin(), xyz.end(), std::numeric_limits<double>::quiet_NaN());
  litter.set_cloud(0, xyz, still);
  EXPECT_EQ(pick(litter, {far, along}), std::nullopt);
}

}  // namespace
}  // namespace pupflow::view
