#include "app/view/skin_mesh.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <utility>

#include "pupflow/geometry.h"
#include "pupflow/skin.h"

namespace pupflow::view {

namespace {

/// Finds the edges of the triangles.
void join(SkinMesh& mesh) {
  std::map<std::pair<int, int>, int> half_edges;  // to the triangle on its left
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int from = mesh.triangles[t][c], to = mesh.triangles[t][(c + 1) % 3];
      const auto other = half_edges.find({to, from});
      if (other != half_edges.end()) {
        mesh.edges.push_back({from, to, {static_cast<int>(t), other->second}});
      }
      half_edges[{from, to}] = static_cast<int>(t);
    }
  }
}

}  // namespace

SkinMesh skin_mesh(int face_points, int shown) {
  std::map<std::array<int, 3>, int> point_of;
  const std::vector<SkinCell> all = skin_cells(face_points);
  for (std::size_t i = 0; i < all.size(); ++i) {
    point_of[{all[i].face, all[i].row, all[i].column}] = static_cast<int>(i);
  }
  const auto spread = [&](int line) {
    return static_cast<int>(
        std::lround(static_cast<double>(line * (face_points - 1)) / (shown - 1)));
  };
  SkinMesh mesh;
  for (const SkinCell& cell : skin_cells(shown)) {
    mesh.points.push_back(point_of.at({cell.face, spread(cell.row), spread(cell.column)}));
  }
  mesh.triangles = mesh.coarse = surface_triangles(shown);
  join(mesh);
  return mesh;
}

SkinMesh refined(const SkinMesh& mesh) {
  SkinMesh fine{mesh.points, mesh.parents, mesh.coarse, {}, {}};
  std::map<std::pair<int, int>, int> middles;
  auto next = static_cast<int>(mesh.points.size() + mesh.parents.size());
  const auto middle = [&](int a, int b) {
    const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), next);
    if (is_new) fine.parents.push_back({a, b}), ++next;
    return found->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(),
                          {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  join(fine);
  return fine;
}

void SkinShape::fit(const SkinMesh& mesh, std::span<const float> xyz) {
  constexpr float kCurved = 0.75f;
  const auto at = [](std::vector<Eigen::Vector3f>& list, int vertex) -> Eigen::Vector3f& {
    return list[static_cast<std::size_t>(vertex)];
  };
  const std::size_t points = mesh.points.size(), all = points + mesh.parents.size();
  places.resize(all);
  normals.assign(all, Eigen::Vector3f::Zero());
  for (std::size_t v = 0; v < points; ++v) {
    places[v] =
        Eigen::Map<const Eigen::Vector3f>(&xyz[3 * static_cast<std::size_t>(mesh.points[v])]);
  }
  // Those of the surface through the points alone; then further ones lie between them.
  for (const auto& [a, b, c] : mesh.coarse) {
    const Eigen::Vector3f twice_area =
        (at(places, b) - at(places, a)).cross(at(places, c) - at(places, a));
    for (const int vertex : {a, b, c}) at(normals, vertex) += twice_area;
  }
  const auto make_unit = [](Eigen::Vector3f& normal) {
    const float length = normal.norm();
    normal *= length > 0 ? 1 / length : 0;
  };
  for (std::size_t v = 0; v < points; ++v) make_unit(normals[v]);
  for (std::size_t v = points; v < all; ++v) {
    const auto& [a, b] = mesh.parents[v - points];
    const Eigen::Vector3f middle = (at(places, a) + at(places, b)) / 2;
    const auto lift = [&](int end) -> Eigen::Vector3f {
      const Eigen::Vector3f& normal = at(normals, end);
      return -(middle - at(places, end)).dot(normal) * normal;
    };
    places[v] = middle + kCurved * (lift(a) + lift(b)) / 2;
    normals[v] = at(normals, a) + at(normals, b);
    make_unit(normals[v]);
  }
}

}  // namespace pupflow::view
