#include "pupflow/skin.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/elementary.h"
#include "pupflow/geometry.h"

namespace pupflow {
namespace {

Eigen::Vector3d square_to_sphere(double u, double v) {
  const double d = 1 - std::abs(u) - std::abs(v), r = 1 - std::abs(d);
  const double phi = r == 0 ? kPi / 4 : (1 + (std::abs(v) - std::abs(u)) / r) * (kPi / 4);
  const double across = r * std::sqrt(2 - r * r);
  const SinCos direction = sincos_fixed(phi);
  return {std::copysign(direction.cos * across, u), std::copysign(direction.sin * across, v),
          std::copysign(1 - r * r, d)};
}

/// Finds the nearest of some points on the unit sphere.
class NearestOnSphere {
 public:
  explicit NearestOnSphere(std::vector<Eigen::Vector3d> points)
      : points_(std::move(points)), by_z_(points_.size()) {
    std::iota(by_z_.begin(), by_z_.end(), 0);
    std::sort(by_z_.begin(), by_z_.end(), [&](int a, int b) { return z(a) < z(b); });
  }

  /// The number of the point nearest to `place`; of equally near ones the lowest.
  int find(const Eigen::Vector3d& place) const {
    int nearest = -1;
    double least = 5;  // squared; more than the sphere's diameter
    // False where the points are too far off in z already, and so are all behind them.
    const auto look_at = [&](int point) {
      const double dz = z(point) - place.z();
      if (dz * dz > least) return false;
      const double squared = (points_[point] - place).squaredNorm();
      if (squared < least || (squared == least && point < nearest)) {
        least = squared;
        nearest = point;
      }
      return true;
    };
    const auto middle =
        std::lower_bound(by_z_.begin(), by_z_.end(), place.z(),
                         [&](int point, double height) { return z(point) < height; });
    for (auto up = middle; up != by_z_.end() && look_at(*up); ++up) {
    }
    for (auto down = middle; down != by_z_.begin() && look_at(*(down - 1)); --down) {
    }
    return nearest;
  }

 private:
  double z(int point) const { return points_[point].z(); }

  std::vector<Eigen::Vector3d> points_;
  std::vector<int> by_z_;
};

}  // namespace

std::vector<SkinCell> skin_cells(int face_points) {
  std::vector<SkinCell> cells;
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < face_points; ++row) {
      for (int column = 0; column < face_points; ++column) cells.push_back({face, row, column});
    }
  }
  return cells;
}

std::vector<std::vector<int>> skin_neighbours(int face_points) {
  std::vector<std::vector<int>> neighbours(skin_cells(face_points).size());
  for (const std::array<int, 3>& triangle : surface_triangles(face_points)) {
    for (const int a : triangle) {
      for (const int b : triangle) {
        if (a != b) neighbours[a].push_back(b);
      }
    }
  }
  for (std::vector<int>& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

SkinSheet skin_sheet(int face_points) {
  const NearestOnSphere afferents(cube_sphere(face_points, 1));
  SkinSheet sheet{8 * face_points, {}};
  const auto middle = [&](int pixel) { return (2 * pixel + 1.0) / sheet.size - 1; };
  for (int row = 0; row < sheet.size; ++row) {
    for (int column = 0; column < sheet.size; ++column) {
      sheet.afferent.push_back(afferents.find(square_to_sphere(middle(column), -middle(row))));
    }
  }
  return sheet;
}

}  // namespace pupflow
