// The skins of a DrawList.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/view/body.h"
#include "app/view/draw_list.h"

namespace pupflow::view {

const SkinMesh& DrawList::mesh_for(float pixels) {
  constexpr float kEdge = 4, kMostEdge = 6;  // of edges between vertices, samples
  constexpr int kMostHalvings = 3;
  const float wanted = std::min(pixels * std::numbers::pi_v<float> / 2 / kEdge, 1000.0f);
  const int shown = std::clamp(static_cast<int>(std::ceil(wanted)), 2, face_points_);
  int halvings = 0;
  for (float edges = kMostEdge / kEdge * static_cast<float>(shown);
       edges < wanted && halvings < kMostHalvings; edges *= 2) {
    ++halvings;
  }
  const auto found = meshes_.find({shown, halvings});
  if (found != meshes_.end()) return found->second;
  SkinMesh mesh = skin_mesh(face_points_, shown);
  for (int i = 0; i < halvings; ++i) mesh = refined(mesh);
  return meshes_.emplace(std::pair(shown, halvings), std::move(mesh)).first->second;
}

const SkinMesh& DrawList::whole_mesh() {
  const auto found = meshes_.find({face_points_, 0});
  if (found != meshes_.end()) return found->second;
  return meshes_.emplace(std::pair(face_points_, 0), skin_mesh(face_points_, face_points_))
      .first->second;
}

void DrawList::add_skin(const Body& body, const Light& light) {
  constexpr float kChord = 0.5f;      // of the height of an arc over its chord
  constexpr float kBothLift = 0.85f;  // point radii: the rest of the points stands out
  const bool cells = scale_.field->of_afferents;
  const SkinMesh& mesh = cells ? whole_mesh() : mesh_for(body.ball.radius / body.pixel);
  shape_.fit(mesh, body.xyz);
  // The soft outline makes up for half a sample.
  const bool soft = drawing_.quality != Quality::fast;
  // Edges are chords: their middles lie lower than a round body.
  const float radius = body.ball.radius;
  const float edge =
      radius * std::sqrt(16 * std::numbers::pi_v<float> / std::numbers::sqrt3_v<float> /
                         static_cast<float>(mesh.triangles.size()));
  const float chord = kChord * edge * edge / (8 * std::max(radius, edge));
  const float lift = (drawing_.draw == Draw::both ? kBothLift : 1.0f) * sphere_radius_ + chord -
                     (soft ? 0.5f * body.pixel : 0.0f);
  for (std::size_t v = 0; v < shape_.places.size(); ++v) {
    shape_.places[v] += lift * shape_.normals[v];
  }
  find_facing(body, mesh);
  std::vector<Vertex> vertices;
  std::vector<float> brightness;
  for (std::size_t v = 0; v < shape_.places.size(); ++v) {
    const Eigen::Vector3f& place = shape_.places[v];
    brightness.push_back(seen_[v] != 0 ? light.at(body.pup, place, shape_.normals[v]) : 0.0f);
    const std::size_t point = v < mesh.points.size() ? static_cast<std::size_t>(mesh.points[v]) : 0;
    vertices.push_back(lit(place, color(body, point), brightness.back()));
  }
  if (soft) add_outline(body, mesh, vertices);
  if (cells) {
    add_cells(body, mesh, vertices, brightness);
    return;
  }
  const auto first = static_cast<std::uint32_t>(skin_.vertices.size());
  skin_.vertices.insert(skin_.vertices.end(), vertices.begin(), vertices.end());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (drawn_[t] == 0) continue;
    for (const int v : mesh.triangles[t]) {
      skin_.indices.push_back(first + static_cast<std::uint32_t>(v));
    }
  }
}

/// Which triangles face the eye, which are drawn, and the vertices of these.
void DrawList::find_facing(const Body& body, const SkinMesh& mesh) {
  constexpr float kEdgeOn = 1e-3f;  // cosine; OpenGL decides about what is this close to edge-on
  const bool all = drawing_.culling == Culling::none;
  facing_.clear();
  drawn_.clear();
  seen_.assign(shape_.places.size(), all ? 1 : 0);
  const auto place = [&](int v) -> const Eigen::Vector3f& {
    return shape_.places[static_cast<std::size_t>(v)];
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f normal = (place(b) - place(a)).cross(place(c) - place(a));
    const Eigen::Vector3f sight = body.sight(place(a));
    const float towards = normal.dot(sight);
    const bool edge_on =
        towards * towards <= kEdgeOn * kEdgeOn * normal.squaredNorm() * sight.squaredNorm();
    facing_.push_back(towards > 0 ? 1 : 0);
    drawn_.push_back(all || towards > 0 || edge_on ? 1 : 0);
    if (drawn_.back() == 0) continue;
    for (const int v : {a, b, c}) seen_[static_cast<std::size_t>(v)] = 1;
  }
}

/// Each corner of a triangle has its part of it in its own color.
void DrawList::add_cells(const Body& body, const SkinMesh& mesh,
                         const std::vector<Vertex>& vertices,
                         const std::vector<float>& brightness) {
  struct Lit {
    Eigen::Vector3f place;
    float brightness;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (drawn_[t] == 0) continue;
    const std::array<int, 3>& triangle = mesh.triangles[t];
    Lit corner[3];
    for (std::size_t c = 0; c < 3; ++c) {
      const auto v = static_cast<std::size_t>(triangle[c]);
      corner[c] = {{vertices[v].x, vertices[v].y, vertices[v].z}, brightness[v]};
    }
    const auto mean = [](const Lit& a, const Lit& b) {
      return Lit{(a.place + b.place) / 2, (a.brightness + b.brightness) / 2};
    };
    const Lit middle{(corner[0].place + corner[1].place + corner[2].place) / 3,
                     (corner[0].brightness + corner[1].brightness + corner[2].brightness) / 3};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto point =
          static_cast<std::size_t>(mesh.points[static_cast<std::size_t>(triangle[c])]);
      const Rgb own = color(body, point);
      const auto first = static_cast<std::uint32_t>(skin_.vertices.size());
      for (const Lit& at : {corner[c], mean(corner[c], corner[(c + 1) % 3]), middle,
                            mean(corner[c], corner[(c + 2) % 3])}) {
        skin_.vertices.push_back(lit(at.place, own, at.brightness));
      }
      for (const std::uint32_t v : {0u, 1u, 2u, 0u, 2u, 3u}) skin_.indices.push_back(first + v);
    }
  }
}

/// A ribbon one sample wide along the outline that fades outwards (Sander et al. 2001,
/// discontinuity edge overdraw).
void DrawList::add_outline(const Body& body, const SkinMesh& mesh,
                           const std::vector<Vertex>& vertices) {
  const auto place = [&](int v) {
    const Vertex& vertex = vertices[static_cast<std::size_t>(v)];
    return Eigen::Vector3f(vertex.x, vertex.y, vertex.z);
  };
  const auto faces_eye = [&](int t) { return facing_[static_cast<std::size_t>(t)]; };
  const auto outer = [&](int v) {
    const Eigen::Vector3f sight = body.sight(place(v)).normalized();
    Eigen::Vector3f across = shape_.normals[static_cast<std::size_t>(v)];
    across -= across.dot(sight) * sight;
    const float length = across.norm();
    Vertex vertex = vertices[static_cast<std::size_t>(v)];
    if (length > 0) across *= body.pixel / length;
    vertex.x += across.x(), vertex.y += across.y(), vertex.z += across.z();
    vertex.a = 0;
    return vertex;
  };
  for (const SkinMesh::Edge& edge : mesh.edges) {
    if (faces_eye(edge.triangle[0]) == faces_eye(edge.triangle[1])) continue;
    const auto first = static_cast<std::uint32_t>(outline_.vertices.size());
    outline_.vertices.insert(
        outline_.vertices.end(),
        {vertices[static_cast<std::size_t>(edge.from)], vertices[static_cast<std::size_t>(edge.to)],
         outer(edge.from), outer(edge.to)});
    for (const std::uint32_t v : {0u, 1u, 2u, 2u, 1u, 3u}) outline_.indices.push_back(first + v);
  }
}

}  // namespace pupflow::view
