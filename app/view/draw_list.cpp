#include "app/view/draw_list.h"

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

}  // namespace

void DrawList::update(const LitterView& litter, const ColorScale& scale, const Camera& camera,
                      Culling culling) {
  xyz_.resize(std::size_t{3} * static_cast<std::size_t>(litter.points));
  sphere_radius_ = static_cast<float>(litter.params.point_radius);
  arena_radius_ = static_cast<float>(litter.params.arena_radius);
  spheres_.clear();
  const LitterField& field = *scale.field;
  const auto pups = static_cast<std::size_t>(litter.pups);
  const auto points = static_cast<std::size_t>(litter.points);
  values_.resize(field.of_afferents ? pups * points : pups);
  field.fill(litter, values_);
  scale_ = scale.fitted(values_);

  const float outside = 1 + kRimWidth;
  Eigen::Vector3f low = arena_radius_ * Eigen::Vector3f(-outside, -outside, -kRimDepth);
  Eigen::Vector3f high = arena_radius_ * Eigen::Vector3f(outside, outside, kRimHeight);
  const bool perspective = camera.projection() == Camera::Projection::perspective;
  const Eigen::Vector3f eye = camera.eye().cast<float>();
  const Eigen::Vector3f backward = camera.backward().cast<float>();
  for (int pup = 0; pup < litter.pups; ++pup) {
    litter.positions.copy_pup_to(pup, xyz_);
    const std::span<const float> xyz = xyz_;
    const bool cull = culling == Culling::hidden;
    const Skin skin = cull ? Skin(xyz, sphere_radius_, camera) : Skin();
    const std::size_t first = static_cast<std::size_t>(pup) * (field.of_afferents ? points : 1);
    Rgb color = field.of_afferents ? Rgb{} : scale_(values_[first]);
    for (std::size_t i = 0; i < points; ++i) {
      const Eigen::Map<const Eigen::Vector3f> point(&xyz[3 * i]);
      if (!point.allFinite()) continue;  // a litter whose numbers went bad shows what is left of it
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
      if (skin.closed) {
        const Eigen::Vector3f normal = skin.normal_map * (point - skin.centre);
        const Eigen::Vector3f sight = perspective ? (eye - point).eval() : backward;
        if (normal.dot(sight) < kFacingAway * normal.norm() * sight.norm()) continue;
      }
      if (field.of_afferents) color = scale_(values_[first + i]);
      spheres_.push_back({point.x(), point.y(), point.z(), color.r, color.g, color.b, 255});
    }
  }
  bounds_.low = low.cast<double>().array() - sphere_radius_;
  bounds_.high = high.cast<double>().array() + sphere_radius_;
}

}  // namespace pupflow::view
