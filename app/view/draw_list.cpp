#include "app/view/draw_list.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace pupflow::view {

namespace {

// A skin counts as closed when its points, spread over the sphere around the whole pup, would be
// this close, in point radii. The holes of a square grid of that spacing are 0.88 radii wide.
constexpr double kClosedSpacing = 1.25;

// Points are left out only when they face this far away (cosine): the skin's outline is bumpy.
constexpr float kFacingAway = -0.4f;

// How far the squares of the points' places may be off the ellipsoid (1 is on it). A pup squeezed
// into another shape can have dents that show its far side.
constexpr float kLeastPlace = 0.75f, kMostPlace = 1.25f;

/// Which way the points of one pup face. A ball whose points have covariance C is stretched to an
/// ellipsoid with normals C^-1 (p - centre).
struct Skin {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  Eigen::Matrix3f normal_map = Eigen::Matrix3f::Identity();
  bool closed = false;

  Skin() = default;
  Skin(std::span<const float> xyz, float point_radius, const Camera& camera) {
    const Eigen::Map<const Eigen::Matrix3Xf> points(xyz.data(), 3,
                                                    static_cast<Eigen::Index>(xyz.size() / 3));
    centre = points.rowwise().mean();
    const float reach = std::sqrt((points.colwise() - centre).colwise().squaredNorm().maxCoeff());
    const double spacing =
        reach * std::sqrt(4 * std::numbers::pi / static_cast<double>(points.cols()));
    if (!(spacing < kClosedSpacing * point_radius)) return;
    // From inside the skin its far side is what one sees.
    if (camera.projection() == Camera::Projection::perspective &&
        (camera.eye().cast<float>() - centre).norm() < 2 * (reach + point_radius)) {
      return;
    }
    Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const Eigen::Vector3f offset = points.col(i) - centre;
      covariance += offset * offset.transpose();
    }
    covariance /= reach * reach * static_cast<float>(points.cols());
    bool invertible = false;
    float determinant = 0;
    covariance.computeInverseAndDetWithCheck(normal_map, determinant, invertible, 1e-6f);
    if (!invertible) return;
    const auto offsets = points.colwise() - centre;
    const auto places =
        (offsets.array() * (normal_map * offsets).array()).colwise().sum() / (3 * reach * reach);
    closed = places.minCoeff() > kLeastPlace && places.maxCoeff() < kMostPlace;
  }
};

Vertex lit(const Eigen::Vector3f& place, Rgb color, float brightness, std::uint8_t cover = 255) {
  const auto byte = [&](std::uint8_t c) {
    return static_cast<std::uint8_t>(std::lround(static_cast<float>(c) * brightness));
  };
  return {place.x(), place.y(), place.z(), byte(color.r), byte(color.g), byte(color.b), cover};
}

/// Whether it may be before the eye, and between the picture's upper and lower edge. Beside the eye a
/// body would get the finest of skins.
bool in_view(const Ball& ball, const Camera& camera) {
  constexpr double kReach = 2;  // of the furthest point, radii
  if (!(ball.radius > 0)) return true;
  const double reach = kReach * static_cast<double>(ball.radius);
  const Eigen::Vector3d place = ball.centre.cast<double>() - camera.eye();
  const double depth = -camera.backward().dot(place), height = std::abs(camera.up().dot(place));
  if (camera.projection() == Camera::Projection::orthographic) {
    return height < camera.half_height() + reach;
  }
  const double slope = camera.half_height() / camera.distance();
  return depth > -reach && height < slope * depth + std::hypot(1, slope) * reach;
}

}  // namespace

struct DrawList::Body {
  std::size_t pup;
  std::span<const float> xyz;
  const Ball& ball;
  Eigen::Vector3f eye, backward;
  bool perspective;
  float pixel;  // edge of a sample at the body, arena units

  std::size_t points() const { return xyz.size() / 3; }
  Eigen::Map<const Eigen::Vector3f> point(std::size_t i) const {
    return Eigen::Map<const Eigen::Vector3f>(&xyz[3 * i]);
  }
  Eigen::Vector3f sight(const Eigen::Vector3f& place) const {
    return perspective ? (eye - place).eval() : backward;
  }
};

void DrawList::update(const LitterView& litter, const ColorScale& scale, const Camera& camera,
                      const Drawing& drawing) {
  drawing_ = drawing;
  camera_ = camera;
  spheres_.clear();
  skin_.clear();
  outline_.clear();
  floor_ = {};
  sphere_radius_ = static_cast<float>(litter.params.point_radius);
  arena_radius_ = static_cast<float>(litter.params.arena_radius);
  wall_height_ =
      std::min(static_cast<float>(litter.params.pup_radius) + sphere_radius_, 0.3f * arena_radius_);
  const LitterField& field = *scale.field;
  const auto pups = static_cast<std::size_t>(litter.pups);
  values_.resize(pups * static_cast<std::size_t>(field.of_afferents ? litter.points : 1));
  field.fill(litter, values_);
  scale_ = scale.fitted(values_, litter.params.preferred_temperature);
  if (face_points_ != litter.params.face_points) meshes_.clear();
  face_points_ = litter.params.face_points;

  find_bodies(litter);
  const Light light(balls_, drawing.quality != Quality::fast);
  const Eigen::Vector3f eye = camera.eye().cast<float>();
  const Eigen::Vector3f backward = camera.backward().cast<float>();
  const bool perspective = camera.projection() == Camera::Projection::perspective;
  const auto unit = static_cast<float>(2 * camera.half_height() / drawing.rows);
  const std::size_t numbers = std::size_t{3} * static_cast<std::size_t>(litter.points);
  for (std::size_t pup = 0; pup < pups; ++pup) {
    const float away = backward.dot(eye - balls_[pup].centre);
    const float pixel =
        perspective ? unit * std::max(away, 0.0f) / static_cast<float>(camera.distance()) : unit;
    const Body body{pup,         std::span(xyz_).subspan(pup * numbers, numbers),
                    balls_[pup], eye,
                    backward,    perspective,
                    pixel};
    if (drawing.culling == Culling::hidden && !in_view(body.ball, camera)) continue;
    const bool has_skin = face_points_ >= 2 && body.ball.radius > 0;
    if (has_skin && drawing.draw != Draw::points) add_skin(body, light);
    if (!has_skin || drawing.draw != Draw::skin) add_spheres(body, light);
  }
  if (drawing.quality != Quality::fast && pups > 0) light.on_floor(arena_radius_, floor_);
}

void DrawList::find_bodies(const LitterView& litter) {
  const auto pups = static_cast<std::size_t>(litter.pups);
  const std::size_t numbers = std::size_t{3} * static_cast<std::size_t>(litter.points);
  xyz_.resize(pups * numbers);
  litter.positions.copy_to(xyz_);
  balls_.assign(pups, Ball());
  const float outside = (1 + kRimWidth) * arena_radius_;
  Eigen::Vector3f low(-outside, -outside, -kSlabDepth * arena_radius_);
  Eigen::Vector3f high(outside, outside, wall_height_);
  for (std::size_t pup = 0; pup < pups; ++pup) {
    const Eigen::Map<const Eigen::Matrix3Xf> points(&xyz_[pup * numbers], 3, litter.points);
    if (points.allFinite()) {
      const Eigen::Vector3f centre = points.rowwise().mean();
      const float mean_square = (points.colwise() - centre).colwise().squaredNorm().mean();
      balls_[pup] = {centre, std::sqrt(mean_square) + sphere_radius_};
      low = low.cwiseMin(points.rowwise().minCoeff());
      high = high.cwiseMax(points.rowwise().maxCoeff());
      continue;
    }
    // A litter whose numbers went bad shows what is left of it.
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      if (!points.col(i).allFinite()) continue;
      low = low.cwiseMin(points.col(i));
      high = high.cwiseMax(points.col(i));
    }
  }
  bounds_.low = low.cast<double>().array() - sphere_radius_;
  bounds_.high = high.cast<double>().array() + sphere_radius_;
}

const SkinMesh& DrawList::mesh_for(float pixels) {
  constexpr float kEdge = 5, kMostEdge = 9;  // of edges between vertices, samples
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

Rgb DrawList::color(const Body& body, std::size_t point) const {
  const bool own = scale_.field->of_afferents;
  return scale_(values_[own ? body.pup * body.points() + point : body.pup]);
}

void DrawList::add_spheres(const Body& body, const Light& light) {
  const bool cull = drawing_.culling == Culling::hidden && body.ball.radius > 0;
  const Skin skin = cull ? Skin(body.xyz, sphere_radius_, camera_) : Skin();
  const bool has_normals = face_points_ >= 2 && body.ball.radius > 0;
  if (has_normals) shape_.fit(whole_mesh(), body.xyz);
  for (std::size_t i = 0; i < body.points(); ++i) {
    const Eigen::Vector3f point = body.point(i);
    if (!point.allFinite()) continue;
    if (skin.closed) {
      const Eigen::Vector3f normal = skin.normal_map * (point - skin.centre);
      const Eigen::Vector3f sight = body.sight(point);
      if (normal.dot(sight) < kFacingAway * normal.norm() * sight.norm()) continue;
    }
    Eigen::Vector3f normal = has_normals ? shape_.normals[i] : point - body.ball.centre;
    if (normal.squaredNorm() < 1e-12f) normal = key_light();
    normal.normalize();
    const float brightness = light.at(body.pup, point + sphere_radius_ * normal, normal);
    spheres_.push_back(lit(point, color(body, i), brightness));
  }
}

void DrawList::add_skin(const Body& body, const Light& light) {
  constexpr float kChord = 0.5f;      // of the height of an arc over its chord
  constexpr float kBothLift = 0.85f;  // point radii: the rest of the points stands out
  constexpr float kSmall = 12;        // a body of fewer samples across shows no single points
  const bool cells = scale_.field->of_afferents && 2 * body.ball.radius > kSmall * body.pixel;
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
    // Where points have colors of their own and are not shown one by one, the first one's do.
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
