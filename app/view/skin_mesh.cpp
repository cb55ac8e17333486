#include "app/view/skin_mesh.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <utility>

#include "pupflow/geometry.h"
#include "pupflow/skin.h"

namespace pupflow::view {

SkinMesh skin_mesh(int face_points, int shown) {
  std::map<std::array<int, 3>, int> point_of;
  const std::vector<SkinCell> all = skin_cells(face_points);
  for (std::size_t i = 0; i < all.size(); ++i) {
    point_of[{all[i].face, all[i].row, all[i].column}] = static_cast<int>(i);
  }
  const auto spread = [&](int line) {
    return static_cast<int>(std::lround(static_cast<double>(line * (face_points - 1)) / (shown - 1)));
  };
  SkinMesh mesh;
  for (const SkinCell& cell : skin_cells(shown)) {
    mesh.points.push_back(point_of.at({cell.face, spread(cell.row), spread(cell.column)}));
  }
  mesh.triangles = surface_triangles(shown);
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
  return mesh;
}

void vertex_normals(const SkinMesh& mesh, std::span<const float> xyz,
                    std::vector<Eigen::Vector3f>& normals) {
  using Vector = Eigen::Map<const Eigen::Vector3f>;
  const auto place = [&](int vertex) {
    return Vector(&xyz[3 * static_cast<std::size_t>(mesh.points[static_cast<std::size_t>(vertex)])]);
  };
  normals.assign(mesh.points.size(), Eigen::Vector3f::Zero());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f twice_area = (place(b) - place(a)).cross(place(c) - place(a));
    for (const int vertex : {a, b, c}) normals[static_cast<std::size_t>(vertex)] += twice_area;
  }
  for (Eigen::Vector3f& normal : normals) {
    const float length = normal.norm();
    normal *= length > 0 ? 1 / length : 0;
  }
}

}  // namespace pupflow::view
