// The closed surface of a pup, through all of its points or through fewer.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace pupflow::view {

/// Which points of a pup are vertices, and how they are joined.
struct SkinMesh {
  /// An edge with the triangles on both sides of it.
  struct Edge {
    int from, to;
    int triangle[2];
  };
  std::vector<int> points;                    // the point of each vertex
  std::vector<std::array<int, 3>> triangles;  // of vertices, counter-clockwise from outside
  std::vector<Edge> edges;
};

/// The surface through `shown` x `shown` points of each face of a pup with `face_points`;
/// 2 <= shown <= face_points.
SkinMesh skin_mesh(int face_points, int shown);

/// The unit normal of a pup's surface at each vertex of `mesh`, outwards; `xyz` holds all points of
/// the pup. Zero where the surface has no area.
void vertex_normals(const SkinMesh& mesh, std::span<const float> xyz,
                    std::vector<Eigen::Vector3f>& normals);

}  // namespace pupflow::view
