#include "app/view/marks.h"

namespace pupflow::view {

Projection::Projection(const Camera& camera, const Bounds& bounds, int width, int height)
    : width_(width), height_(height) {
  const CameraMatrices matrices = camera.matrices(width_ / height_, bounds);
  clip_from_world_ =
      matrices.clip_from_eye.cast<double>() * matrices.eye_from_world.cast<double>();
}

bool Projection::place(const Eigen::Vector3d& world, Eigen::Vector2d& pixels) const {
  const Eigen::Vector4d clip = clip_from_world_ * Eigen::Vector4d(world.x(), world.y(), world.z(), 1);
  if (!(clip.w() > 1e-6)) return false;
  pixels = {(1 + clip.x() / clip.w()) / 2 * width_, (1 - clip.y() / clip.w()) / 2 * height_};
  return true;
}

}  // namespace pupflow::view
