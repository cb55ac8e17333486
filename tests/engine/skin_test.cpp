// How afferents lie on the skin, against definitions worked out in another way.
#include "pupflow/skin.h"

#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <set>

#include "pupflow/geometry.h"

namespace pupflow {
namespace {

TEST(SkinCells, AreTheGridsOfTheFaces) {
  for (const int k : {2, 3, 7}) {
    const auto points = cube_sphere(k, 1);
    const std::vector<SkinCell> cells = skin_cells(k);
    ASSERT_EQ(cells.size(), points.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      Eigen::Index axis = 0;
      points[i].cwiseAbs().maxCoeff(&axis);
      EXPECT_EQ(cells[i].face, axis + (points[i][axis] < 0 ? 3 : 0));
      EXPECT_EQ(i,
                static_cast<std::size_t>((cells[i].face * k + cells[i].row) * k + cells[i].column));
    }
  }
}

TEST(SkinNeighbours, AreMutualAndNear) {
  for (const int k : {2, 3, 7}) {
    const auto points = cube_sphere(k, 1);
    const auto neighbours = skin_neighbours(k);
    std::size_t edges = 0;
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
      EXPECT_GE(neighbours[i].size(), 3u);
      EXPECT_TRUE(std::is_sorted(neighbours[i].begin(), neighbours[i].end()));
      edges += neighbours[i].size();
      for (const int j : neighbours[i]) {
        const auto& back = neighbours[static_cast<std::size_t>(j)];
        EXPECT_EQ(std::count(back.begin(), back.end(), static_cast<int>(i)), 1);
        EXPECT_LT((points[i] - points[j]).norm(), 3.0 / k);
      }
    }
    // A closed surface of 12 k^2 - 4 triangles, each edge between two of them, counted twice.
    EXPECT_EQ(edges, 2u * (12 * k * k - 4) * 3 / 2);
  }
}

/// The octahedral map by the angle within a quarter of the square: another form of skin.h's.
Eigen::Vector3d mapped(double u, double v) {
  const bool upper = std::abs(u) + std::abs(v) <= 1;
  // The lower half is the upper one, mirrored at the sides of the inner square.
  const double a = upper ? std::abs(u) : 1 - std::abs(v), b = upper ? std::abs(v) : 1 - std::abs(u);
  const double r = a + b, angle = r > 0 ? b / r * std::numbers::pi / 2 : 0;
  const double across = r * std::sqrt(2 - r * r), z = (1 - r * r) * (upper ? 1 : -1);
  return {std::copysign(across * std::cos(angle), u), std::copysign(across * std::sin(angle), v),
          z};
}

TEST(SkinSheet, EveryPixelStandsForTheSameArea) {
  constexpr double kStep = 1e-5;
  for (const double u : {-0.93, -0.41, 0.07, 0.33, 0.72}) {
    for (const double v : {-0.88, -0.29, 0.11, 0.56}) {
      const Eigen::Vector3d du = (mapped(u + kStep, v) - mapped(u - kStep, v)) / (2 * kStep);
      const Eigen::Vector3d dv = (mapped(u, v + kStep) - mapped(u, v - kStep)) / (2 * kStep);
      EXPECT_NEAR(du.cross(dv).norm(), std::numbers::pi, 1e-6) << u << ' ' << v;
    }
  }
}

TEST(SkinSheet, APixelBelongsToTheNearestAfferent) {
  for (const int k : {2, 3, 7}) {
    const auto points = cube_sphere(k, 1);
    const SkinSheet sheet = skin_sheet(k);
    ASSERT_EQ(sheet.size, 8 * k);
    ASSERT_EQ(sheet.afferent.size(), static_cast<std::size_t>(sheet.size) * sheet.size);
    for (int row = 0; row < sheet.size; ++row) {
      for (int column = 0; column < sheet.size; ++column) {
        const double u = (column + 0.5) * 2 / sheet.size - 1, v = 1 - (row + 0.5) * 2 / sheet.size;
        const Eigen::Vector3d place = mapped(u, v);
        const int owner = sheet.afferent[static_cast<std::size_t>(row) * sheet.size + column];
        for (const Eigen::Vector3d& other : points) {
          EXPECT_LE((points[owner] - place).norm(), (other - place).norm() + 1e-12);
        }
      }
    }
  }
}

TEST(SkinSheet, ShowsEveryAfferentNearlyEquallyLarge) {
  for (const int k : {2, 7, 32}) {
    const SkinSheet sheet = skin_sheet(k);
    std::vector<int> pixels(static_cast<std::size_t>(6) * k * k, 0);
    for (const int afferent : sheet.afferent) ++pixels[static_cast<std::size_t>(afferent)];
    EXPECT_GE(*std::min_element(pixels.begin(), pixels.end()), 5) << k;  // 32/3 on average
    EXPECT_LE(*std::max_element(pixels.begin(), pixels.end()), 20) << k;
  }
}

}  // namespace
}  // namespace pupflow
