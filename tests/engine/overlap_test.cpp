#include "pupflow/overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pupflow/geometry.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

using Eigen::Vector3d;

/// Rest spheres of one litter, far from floor and wall, where the test puts them.
struct Spheres {
  explicit Spheres(int pups, int face_points = 7) : simulation(make(pups, face_points)) {}
  static Params make(int pups, int face_points) {
    Params p = testing::weightless();
    p.pups = pups;
    p.face_points = face_points;
    return p;
  }
  void put(int pup, const Vector3d& centre, double radius = 0.25) {
    testing::Points points;
    for (const auto& q : cube_sphere(simulation.params().face_points, radius))
      points.push_back(centre + q);
    testing::place(simulation, pup, points, testing::Points(points.size(), Vector3d::Zero()));
  }
  Overlap overlap() const { return measure_overlap(simulation); }
  Simulation simulation;
};

/// Points of a rest sphere whose x lies beyond `x`.
int points_beyond(int face_points, double x) {
  int count = 0;
  for (const Vector3d& q : cube_sphere(face_points, 0.25)) count += q.x() > x ? 1 : 0;
  return count;
}

TEST(Overlap, SpheresApartHaveOnlyADistance) {
  Spheres two(2);
  two.put(0, {0, 0, 5});
  two.put(1, {0.3, 0.4, 6.2});
  const Overlap o = two.overlap();
  EXPECT_NEAR(o.nearest, 1.3, 1e-12);
  EXPECT_NEAR(o.least, 1.3, 1e-12);
  EXPECT_EQ(o.inside, 0);
  EXPECT_EQ(o.inside_exposed, 0);
}

TEST(Overlap, DistancesAreOfTheNearestCentres) {
  Spheres row(3);
  row.put(0, {0, 0, 5});
  row.put(1, {1, 0, 5});
  row.put(2, {3, 0, 5});
  const Overlap o = row.overlap();
  EXPECT_NEAR(o.nearest, (1 + 1 + 2) / 3.0, 1e-12);
  EXPECT_NEAR(o.least, 1, 1e-12);
}

TEST(Overlap, TwoSpheresLoseACapToEachOther) {
  for (const int k : {2, 3, 7, 15}) {
    for (const double distance : {0.15, 0.3, 0.4, 0.49}) {
      Spheres two(2, k);
      two.put(0, {0, 0, 5});
      two.put(1, {distance, 0, 5});
      // A point of one is inside the other's sphere when it lies beyond the middle. The surface
      // runs within the sphere by the sagitta of a triangle at most, edge^2 / (8 r).
      const double sagitta = 0.3 / (k * k);
      const double of_each = two.overlap().inside * 6 * k * k;
      EXPECT_LT(of_each, points_beyond(k, distance / 2) + 0.5) << k << " " << distance;
      EXPECT_GT(of_each, points_beyond(k, distance / 2 + sagitta) - 0.5) << k << " " << distance;
    }
  }
}

TEST(Overlap, OneInsideAnother) {
  Spheres two(2);
  two.put(0, {0.01, 0.02, 5}, 0.1);
  two.put(1, {0, 0, 5}, 0.25);
  EXPECT_EQ(two.overlap().inside, 0.5);  // all points of the small one, none of the large
  EXPECT_EQ(two.overlap().inside_exposed, 1) << "nobody touches before the first step";
}

TEST(Overlap, APointInTwoBodiesCountsOnce) {
  Spheres three(3);
  three.put(0, {0, 0, 5}, 0.1);
  three.put(1, {0, 0, 5}, 0.25);
  three.put(2, {0, 0, 5}, 0.26);
  EXPECT_DOUBLE_EQ(three.overlap().inside, 2 / 3.0);
}

TEST(Overlap, TheHollowOfABentBodyIsOutside) {
  // A body bent round a small one like a bowl, which lies within its bounds but not within it.
  Spheres two(2);
  testing::Points bowl;
  for (Vector3d q : cube_sphere(7, 0.25)) {
    q.z() = 0.2 * q.z() + 8 * (q.x() * q.x() + q.y() * q.y());
    bowl.push_back(q + Vector3d(0, 0, 5));
  }
  testing::place(two.simulation, 0, bowl, testing::Points(bowl.size(), Vector3d::Zero()));
  two.put(1, {0, 0, 5.25}, 0.05);
  EXPECT_EQ(two.overlap().inside, 0);
  two.put(1, {0, 0, 5}, 0.005);  // in the bowl's wall, 0.1 thick in the middle
  EXPECT_EQ(two.overlap().inside, 0.5);
}

TEST(Overlap, AGridOfEqualCoordinatesIsNoTrap) {
  // Rays that meet corners and edges of the surface: the same cloud shifted along one axis.
  Spheres two(2, 4);
  two.put(0, {0, 0, 5});
  for (const Vector3d& shift : {Vector3d(0.125, 0, 0), Vector3d(0, 0.125, 0), Vector3d(0, 0, 0.125),
                                Vector3d(0, 0, -0.125)}) {
    two.put(1, Vector3d(0, 0, 5) + shift);
    // The cube's symmetry makes all directions alike.
    EXPECT_DOUBLE_EQ(two.overlap().inside * 96, points_beyond(4, 0.125 / 2)) << shift.transpose();
  }
}

TEST(Overlap, TouchingPointsInsideAreNotExposed) {
  Spheres two(2);
  two.put(0, {0, 0, 5});
  two.put(1, {0.35, 0, 5});
  two.simulation.step();
  const Overlap o = two.overlap();
  int inside = 0, exposed = 0;
  // Both are still nearly spheres: count what a sphere would say, leaving a margin at its surface.
  const auto all = testing::all_positions(two.simulation);
  const int n = two.simulation.points();
  for (int i = 0; i < 2 * n; ++i) {
    const Vector3d other = two.simulation.view().positions.mean(i < n ? 1 : 0);
    if ((all[i] - other).norm() > 0.245) continue;
    ++inside;
    exposed += two.simulation.view().touched[i] < 0 ? 1 : 0;
  }
  EXPECT_GT(inside, 20);
  EXPECT_NEAR(o.inside * 2 * n, inside, 0.2 * inside);
  EXPECT_NEAR(o.inside_exposed * o.inside * 2 * n, exposed, 0.2 * inside + 1);
  EXPECT_LT(o.inside_exposed, 1);
}

TEST(Overlap, FewerThanTwoPupsOverlapNothing) {
  for (const int pups : {0, 1}) {
    const Overlap o = Spheres(pups).overlap();
    EXPECT_TRUE(std::isinf(o.nearest) && std::isinf(o.least));
    EXPECT_EQ(o.inside, 0);
  }
}

TEST(Overlap, AMeterGoesFromLitterToLitter) {
  OverlapMeter meter;
  for (const int k : {7, 3, 7}) {
    Spheres two(2, k);
    two.put(0, {0, 0, 5});
    two.put(1, {0.3, 0, 5});
    EXPECT_EQ(meter.measure(two.simulation).inside, two.overlap().inside);
  }
}

TEST(OverlapMeans, WeighExposedPointsByThoseInside) {
  OverlapMeans means;
  EXPECT_TRUE(std::isnan(means.means().nearest));
  means.add({0.5, 0.4, 0, 0});
  means.add({0.7, 0.3, 0.1, 0.5});
  means.add({0.6, 0.6, 0.3, 0.1});
  const Overlap o = means.means();
  EXPECT_EQ(means.count(), 3);
  EXPECT_NEAR(o.nearest, 0.6, 1e-15);
  EXPECT_EQ(o.least, 0.3);
  EXPECT_NEAR(o.inside, 0.4 / 3, 1e-15);
  EXPECT_NEAR(o.inside_exposed, 0.08 / 0.4, 1e-15);
}

}  // namespace
}  // namespace pupflow
