#include "app/view/pick.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "app/view/skin_mesh.h"

namespace pupflow::view {

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// How far along the ray it first meets a ball; kNone where it does not.
double distance_to_ball(const Ray& ray, const Eigen::Vector3d& centre, double radius) {
  const Eigen::Vector3d away = centre - ray.from;
  const double middle = away.dot(ray.along);
  const double square = radius * radius - (away - middle * ray.along).squaredNorm();
  if (square < 0) return kNone;
  const double first = middle - std::sqrt(square), last = middle + std::sqrt(square);
  return first >= 0 ? first : last >= 0 ? last : kNone;
}

/// The same for a triangle, from either side (Möller & Trumbore 1997).
double distance_to_triangle(const Ray& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, across = ray.along.cross(ac);
  const double volume = ab.dot(across);
  if (volume == 0) return kNone;
  const Eigen::Vector3d from = ray.from - a;
  const double u = from.dot(across) / volume;
  if (!(u >= 0 && u <= 1)) return kNone;
  const Eigen::Vector3d upright = from.cross(ab);
  const double v = ray.along.dot(upright) / volume;
  if (!(v >= 0 && u + v <= 1)) return kNone;
  const double distance = ac.dot(upright) / volume;
  return distance >= 0 ? distance : kNone;
}

/// The bodies of one litter.
class Bodies {
 public:
  explicit Bodies(const LitterView& litter)
      : litter_(litter),
        radius_(litter.params.point_radius),
        mesh_(skin_mesh(litter.params.face_points, litter.params.face_points)) {}

  double distance(const Ray& ray, int pup) {
    xyz_.resize(std::size_t{3} * static_cast<std::size_t>(litter_.points));
    litter_.positions.copy_pup_to(pup, xyz_);
    const Eigen::Map<const Eigen::Matrix3Xf> points(xyz_.data(), 3, litter_.points);
    if (!points.allFinite()) return to_points(ray, points);
    const Eigen::Vector3f centre = points.rowwise().mean();
    const float reach = (points.colwise() - centre).colwise().norm().maxCoeff();
    const double ball = static_cast<double>(reach) + 1.01 * radius_;
    if (distance_to_ball(ray, centre.cast<double>(), ball) == kNone) return kNone;
    return to_skin(ray);
  }

 private:
  double to_points(const Ray& ray, const Eigen::Map<const Eigen::Matrix3Xf>& points) const {
    double nearest = kNone;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      if (!points.col(i).allFinite()) continue;
      nearest = std::min(nearest, distance_to_ball(ray, points.col(i).cast<double>(), radius_));
    }
    return nearest;
  }

  double to_skin(const Ray& ray) {
    shape_.fit(mesh_, xyz_);
    const auto place = [&](int vertex) -> Eigen::Vector3d {
      const auto v = static_cast<std::size_t>(vertex);
      return shape_.places[v].cast<double>() + radius_ * shape_.normals[v].cast<double>();
    };
    double nearest = kNone;
    for (const auto& [a, b, c] : mesh_.triangles) {
      nearest = std::min(nearest, distance_to_triangle(ray, place(a), place(b), place(c)));
    }
    return nearest;
  }

  const LitterView& litter_;
  double radius_;
  SkinMesh mesh_;
  SkinShape shape_;
  std::vector<float> xyz_;  // of one pup
};

}  // namespace

Ray sight(const Camera& camera, double aspect, double x, double y) {
  const Eigen::Vector3d aside =
      camera.half_height() * ((2 * x - 1) * aspect * camera.right() + (1 - 2 * y) * camera.up());
  if (camera.projection() == Camera::Projection::orthographic) {
    constexpr double kBack = 1e4;  // distances
    return {camera.eye() + aside + kBack * camera.distance() * camera.backward(),
            -camera.backward()};
  }
  return {camera.eye(), (camera.target() + aside - camera.eye()).normalized()};
}

std::optional<int> pick(const LitterView& litter, const Ray& ray) {
  Bodies bodies(litter);
  std::optional<int> picked;
  double nearest = kNone;
  for (int pup = 0; pup < litter.pups; ++pup) {
    const double distance = bodies.distance(ray, pup);
    if (distance >= nearest) continue;
    nearest = distance;
    picked = pup;
  }
  return picked;
}

}  // namespace pupflow::view
