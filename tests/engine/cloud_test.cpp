#include "engine/cloud.h"
#include "pupflow/geometry.h"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pupflow {
namespace {

TEST(Cloud, PointsSitOnTheSphere) {
  for (const int k : {2, 3, 7, 32}) {
    const auto rest = cube_sphere(k, 0.25);
    ASSERT_EQ(rest.size(), 6u * k * k);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& q : rest) {
      ASSERT_NEAR(q.norm(), 0.25, 1e-15);
      sum += q;
    }
    EXPECT_LT(sum.norm(), 1e-13);
  }
}

TEST(Cloud, TheSecondHalfMirrorsTheFirst) {
  for (const int k : {2, 3, 7, 32}) {
    const auto rest = cube_sphere(k, 0.25);
    const std::size_t half = rest.size() / 2;
    for (std::size_t i = 0; i < half; ++i) ASSERT_EQ(rest[half + i], Eigen::Vector3d(-rest[i]));
  }
}

TEST(Cloud, SpacingIsAsEvenAsMeasured) {
  const auto rest = cube_sphere(7, 0.25);
  double sum = 0, least = 1, greatest = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    double nearest = 1;
    for (std::size_t j = 0; j < rest.size(); ++j) {
      if (j != i) nearest = std::min(nearest, (rest[i] - rest[j]).norm());
    }
    sum += nearest;
    least = std::min(least, nearest);
    greatest = std::max(greatest, nearest);
  }
  EXPECT_NEAR(sum / static_cast<double>(rest.size()), 0.0472, 0.0001);
  EXPECT_NEAR(greatest / least, 1.15, 0.01);
}

TEST(Surface, IsClosedAndEveryEdgeIsUsedOnceEachWay) {
  for (const int k : {2, 3, 7, 32}) {
    const auto triangles = surface_triangles(k);
    ASSERT_EQ(triangles.size(), 12u * k * k - 4);
    std::map<std::pair<int, int>, int> uses;
    for (const auto& t : triangles) {
      for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(t[i] >= 0 && t[i] < 6 * k * k);
        ++uses[{t[i], t[(i + 1) % 3]}];
      }
    }
    for (const auto& [edge, count] : uses) {
      ASSERT_EQ(count, 1);
      ASSERT_TRUE(uses.contains({edge.second, edge.first}));
    }
    // Euler: a closed surface like a sphere has V - E + F = 2.
    EXPECT_EQ(6 * k * k - static_cast<int>(uses.size()) / 2 + static_cast<int>(triangles.size()),
              2);
  }
}

TEST(Surface, FacesOutwardAndEnclosesNearlyTheSphere) {
  const double pi = std::acos(-1.0);
  for (const int k : {2, 3, 7, 32}) {
    const auto rest = cube_sphere(k, 0.25);
    double volume = 0, shortest = 1, longest = 0;
    for (const auto& [a, b, c] : surface_triangles(k)) {
      const double six = rest[a].dot(rest[b].cross(rest[c]));
      ASSERT_GT(six, 0);
      volume += six / 6;
      for (const double edge :
           {(rest[a] - rest[b]).norm(), (rest[b] - rest[c]).norm(), (rest[c] - rest[a]).norm()}) {
        shortest = std::min(shortest, edge);
        longest = std::max(longest, edge);
      }
    }
    const double sphere = 4 * pi / 3 * std::pow(0.25, 3);
    EXPECT_LT(volume, sphere);
    EXPECT_GT(volume, sphere * (1 - 1.6 / (k * k)));
    EXPECT_LT(longest, 2.5 * shortest) << "neighbours only, k " << k;
  }
}

template <class Real>
class CloudModes : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(CloudModes, Precisions);

TYPED_TEST(CloudModes, AreOrthonormalAndPaddedWithZeros) {
  const double tolerance = sizeof(TypeParam) == 4 ? 2e-6 : 1e-13;
  for (const int k : {2, 7, 15, 32}) {
    const auto cloud = make_cloud<TypeParam>(cube_sphere(k, 0.25));
    for (int a = 1; a < kModes; ++a) {
      double mean = 0;
      for (int i = 0; i < cloud.points; ++i) mean += cloud.mode_row(a)[i];
      EXPECT_NEAR(mean, 0, tolerance * 10);
      for (int b = 1; b < kModes; ++b) {
        double dot = 0;
        for (int i = 0; i < cloud.stride; ++i) {
          dot +=
              static_cast<double>(cloud.mode_row(a)[i]) * static_cast<double>(cloud.mode_row(b)[i]);
        }
        EXPECT_NEAR(dot, a == b ? 1 : 0, tolerance) << "k " << k << " modes " << a << " " << b;
      }
    }
    for (int m = 0; m < kModes; ++m) {
      for (int i = cloud.points; i < cloud.stride; ++i) EXPECT_EQ(cloud.mode_row(m)[i], 0);
    }
  }
}

TEST(Cloud, ModesSpanTheNineMonomials) {
  const auto rest = cube_sphere(7, 0.25);
  const auto cloud = make_cloud<double>(rest);
  const auto n = static_cast<Eigen::Index>(rest.size());
  Eigen::MatrixXd q(n, 9), phi(n, kModes - 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& p = rest[static_cast<std::size_t>(i)];
    q.row(i) << p.x(), p.y(), p.z(), p.x() * p.x(), p.y() * p.y(), p.z() * p.z(), p.x() * p.y(),
        p.y() * p.z(), p.z() * p.x();
    for (int m = 1; m < kModes; ++m) phi(i, m - 1) = cloud.mode_row(m)[i];
  }
  q.rowwise() -= q.colwise().mean();
  EXPECT_LT((q - phi * (phi.transpose() * q)).norm(), 1e-12 * q.norm());
  const Eigen::MatrixXd moments = q.transpose() * q;
  const auto singular = Eigen::JacobiSVD<Eigen::MatrixXd>(moments).singularValues();
  EXPECT_LT(singular[8], 1e-12 * singular[7]);  // rank 8: the ninth direction is empty
}

}  // namespace
}  // namespace pupflow
