#include "app/view/marks.h"

#include <algorithm>

namespace pupflow::view {

Projection::Projection(const Camera& camera, const Bounds& bounds, int width, int height,
                       std::span<const Ball> bodies)
    : camera_(camera), bodies_(bodies), width_(width), height_(height) {
  const CameraMatrices matrices = camera.matrices(width_ / height_, bounds);
  clip_from_world_ = matrices.clip_from_eye.cast<double>() * matrices.eye_from_world.cast<double>();
}

bool Projection::place(const Eigen::Vector3d& world, Eigen::Vector2d& pixels) const {
  const Eigen::Vector4d clip =
      clip_from_world_ * Eigen::Vector4d(world.x(), world.y(), world.z(), 1);
  if (!(clip.w() > 1e-6)) return false;
  pixels = {(1 + clip.x() / clip.w()) / 2 * width_, (1 - clip.y() / clip.w()) / 2 * height_};
  return true;
}

bool Projection::hidden(const Eigen::Vector3d& world) const {
  const bool perspective = camera_.projection() == Camera::Projection::perspective;
  const Eigen::Vector3d sight =
      perspective ? (camera_.eye() - world).normalized() : camera_.backward();
  return std::ranges::any_of(bodies_, [&](const Ball& body) {
    const Eigen::Vector3d away = body.centre.cast<double>() - world;
    const double along = away.dot(sight), radius = static_cast<double>(body.radius);
    return along > 0 && away.squaredNorm() - along * along < radius * radius;
  });
}

}  // namespace pupflow::view
