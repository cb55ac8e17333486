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
  std::vector<int> points;                    // the point of each vertex, as far as they are points
  std::vector<std::array<int, 2>> parents;    // the vertices that each further one lies between
  std::vector<std::array<int, 3>> coarse;     // triangles of points alone, which give the normals
  std::vector<std::array<int, 3>> triangles;  // of all vertices, counter-clockwise from outside
  std::vector<Edge> edges;
};

/// The surface through `shown` x `shown` points of each face of a pup with `face_points`;
/// 2 <= shown <= face_points.
SkinMesh skin_mesh(int face_points, int shown);

/// The same with a vertex more in the middle of each edge.
SkinMesh refined(const SkinMesh& mesh);

/// A pup's surface: place and outward unit normal of each vertex. A normal is zero where the
/// surface has no area.
struct SkinShape {
  std::vector<Eigen::Vector3f> places, normals;

  /// Through the points of a pup, `xyz`. Further vertices lie on a surface that is curved as the
  /// normals say (Boubekeur & Alexa 2008, Phong tessellation).
  void fit(const SkinMesh& mesh, std::span<const float> xyz);
};

}  // namespace pupflow::view
