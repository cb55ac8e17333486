#include "app/view/draw_list.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/view/body.h"

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

void DrawList::update(const LitterView& litter, const ColorScale& scale, const Camera& camera,
                      const Drawing& drawing) {
  drawing_ = drawing;
  camera_ = camera;
  spheres_.clear();
  skin_.clear();
  outline_.clear();
  ellipsoids_.clear();
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
    if (is_small(body)) {
      add_ellipsoid(body, light);
      continue;
    }
    const bool has_skin = face_points_ >= 2 && body.ball.radius > 0;
    if (has_skin && drawing.draw != Draw::points) add_skin(body, light);
    if (!has_skin || drawing.draw != Draw::skin) add_spheres(body, light);
  }
  std::ranges::sort(ellipsoids_, {}, [&](const Ellipsoid& each) {
    return backward.dot(Eigen::Map<const Eigen::Vector3f>(each.centre));
  });
  if (drawing.quality != Quality::fast && pups > 0) light.on_floor(arena_radius_, unit, floor_);
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

Rgb DrawList::color(const Body& body, std::size_t point) const {
  const bool own = scale_.field->of_afferents;
  return scale_(values_[own ? body.pup * body.points() + point : body.pup]);
}

/// A field of the afferents keeps its cells, and points that are asked for are shown, longer.
bool DrawList::is_small(const Body& body) const {
  constexpr float kSmall = 24, kSmallInDetail = 12;  // samples across
  const bool detail = scale_.field->of_afferents || drawing_.draw != Draw::skin;
  return drawing_.culling == Culling::hidden && body.ball.radius > 0 &&
         2 * body.ball.radius < (detail ? kSmallInDetail : kSmall) * body.pixel;
}

void DrawList::add_ellipsoid(const Body& body, const Light& light) {
  const Eigen::Map<const Eigen::Matrix3Xf> points(body.xyz.data(), 3,
                                                  static_cast<Eigen::Index>(body.points()));
  const Eigen::Matrix3f shape = ellipsoid_shape(points, body.ball.centre, sphere_radius_);
  ellipsoids_.push_back(ellipsoid(body.ball, shape, mean_color(body), body.pup, light));
}

Rgb DrawList::mean_color(const Body& body) const {
  if (!scale_.field->of_afferents) return color(body, 0);
  std::size_t r = 0, g = 0, b = 0;
  for (std::size_t i = 0; i < body.points(); ++i) {
    const Rgb own = color(body, i);
    r += own.r, g += own.g, b += own.b;
  }
  const auto mean = [&](std::size_t sum) {
    return static_cast<std::uint8_t>((sum + body.points() / 2) / body.points());
  };
  return {mean(r), mean(g), mean(b)};
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

}  // namespace pupflow::view
