#include "pupflow/geometry.h"

#include <cassert>
#include <cmath>

namespace pupflow {
namespace {

Eigen::Vector3d cube_to_sphere(double x, double y, double z) {
  const double xx = x * x, yy = y * y, zz = z * z;
  return {x * std::sqrt(1 - yy / 2 - zz / 2 + yy * zz / 3),
          y * std::sqrt(1 - zz / 2 - xx / 2 + zz * xx / 3),
          z * std::sqrt(1 - xx / 2 - yy / 2 + xx * yy / 3)};
}

}  // namespace

std::vector<Eigen::Vector3d> cube_sphere(int face_points, double radius) {
  assert(face_points >= 1 && radius > 0);
  std::vector<Eigen::Vector3d> points;
  points.reserve(static_cast<std::size_t>(6) * face_points * face_points);
  const auto grid = [&](int i) { return (2 * i + 1.0) / face_points - 1; };
  for (const double side : {1.0, -1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < face_points; ++i) {
        for (int j = 0; j < face_points; ++j) {
          Eigen::Vector3d on_cube;
          on_cube[axis] = 1;
          on_cube[(axis + 1) % 3] = grid(i);
          on_cube[(axis + 2) % 3] = grid(j);
          points.push_back(side * radius * cube_to_sphere(on_cube.x(), on_cube.y(), on_cube.z()));
        }
      }
    }
  }
  return points;
}

std::vector<std::array<int, 3>> surface_triangles(int face_points) {
  assert(face_points >= 2);
  const int k = face_points, last = k - 1;
  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(static_cast<std::size_t>(12) * k * k - 4);
  using Cell = std::array<int, 3>;  // column of the grid along x, y and z; the face's own is unused
  // The point of `cube_sphere` in one cell of the face whose normal is `side` times an axis.
  const auto point = [k, last](int axis, int side, const Cell& cell) {
    const int i = cell[(axis + 1) % 3], j = cell[(axis + 2) % 3];
    const int face = side > 0 ? axis : 3 + axis;
    return (face * k + (side > 0 ? i : last - i)) * k + (side > 0 ? j : last - j);
  };
  const auto add = [&](bool outward, int a, int b, int c) {
    triangles.push_back(outward ? Cell{a, b, c} : Cell{a, c, b});
  };
  const auto add_quad = [&](bool outward, int a, int b, int c, int d) {
    add(outward, a, b, c);
    add(outward, a, c, d);
  };
  const auto end_of = [last](int side) { return side > 0 ? last : 0; };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const int side : {1, -1}) {  // the face itself
      const auto at = [&](int i, int j) {
        Cell cell{};
        cell[u] = i, cell[v] = j;
        return point(axis, side, cell);
      };
      for (int i = 0; i < last; ++i) {
        for (int j = 0; j < last; ++j)
          add_quad(side > 0, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
    for (const int su : {1, -1}) {  // the four edges along this axis, between faces u and v
      for (const int sv : {1, -1}) {
        const auto at = [&](int face_axis, int side, int along) {
          Cell cell{};
          cell[axis] = along, cell[u] = end_of(su), cell[v] = end_of(sv);
          return point(face_axis, side, cell);
        };
        for (int i = 0; i < last; ++i)
          add_quad(su == sv, at(u, su, i), at(v, sv, i), at(v, sv, i + 1), at(u, su, i + 1));
      }
    }
  }
  for (const int sx : {1, -1}) {
    for (const int sy : {1, -1}) {
      for (const int sz : {1, -1}) {
        const Cell corner{end_of(sx), end_of(sy), end_of(sz)};
        add(sx * sy * sz > 0, point(0, sx, corner), point(1, sy, corner), point(2, sz, corner));
      }
    }
  }
  return triangles;
}

}  // namespace pupflow
