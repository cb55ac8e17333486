#include "app/view/ellipsoid.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace pupflow::view {

namespace {

std::uint8_t byte(float share) {
  return static_cast<std::uint8_t>(std::lround(255 * share));
}

}  // namespace

Eigen::Matrix3f ellipsoid_shape(const Eigen::Map<const Eigen::Matrix3Xf>& points,
                                const Eigen::Vector3f& centre, float point_radius) {
  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3f offset = points.col(i) - centre;
    covariance += offset * offset.transpose();
  }
  covariance /= static_cast<float>(points.cols());
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> axes;
  axes.computeDirect(covariance);
  // Points on a sphere have a third of its squared radius along each axis.
  const Eigen::Vector3f lengths =
      (3 * axes.eigenvalues()).cwiseMax(0.0f).cwiseSqrt().array() + point_radius;
  return axes.eigenvectors() * lengths.asDiagonal() * axes.eigenvectors().transpose();
}

Ellipsoid ellipsoid(const Ball& ball, const Eigen::Matrix3f& shape, Rgb color, std::size_t own,
                    const Light& light) {
  const Eigen::Vector3f& c = ball.centre;
  Ellipsoid result{{c.x(), c.y(), c.z()},
                   {shape(0, 0), shape(1, 1), shape(2, 2), shape(0, 1), shape(0, 2), shape(1, 2)},
                   {color.r, color.g, color.b, 255},
                   {},
                   {},
                   ball.radius};
  for (int axis = 0; axis < 3; ++axis) {
    // The place whose normal goes along the axis: S S n, scaled to the surface.
    const Eigen::Vector3f normal = Eigen::Vector3f::Unit(axis);
    const Eigen::Vector3f stretched = shape * normal;
    const Eigen::Vector3f place = shape * stretched / stretched.norm();
    for (const int side : {0, 1}) {
      const float sign = side == 0 ? 1.0f : -1.0f;
      const Light::Left left = light.left(own, c + sign * place, sign * normal);
      result.sky[side][axis] = byte(left.sky);
      result.key[side][axis] = byte(left.key);
    }
  }
  return result;
}

}  // namespace pupflow::view
