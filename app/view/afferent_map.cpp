#include "app/view/afferent_map.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "pupflow/geometry.h"
#include "pupflow/skin.h"

namespace pupflow::view {

namespace {

/// The place on the cube that is so many cells (`row`, `column`) into a face.
Eigen::Vector3d on_cube(int face, double row, double column, int face_points) {
  const double side = face < 3 ? 1 : -1;
  const int axis = face % 3;
  Eigen::Vector3d place;
  place[axis] = side;
  place[(axis + 1) % 3] = side * (2 * row / face_points - 1);
  place[(axis + 2) % 3] = side * (2 * column / face_points - 1);
  return place;
}

/// The directions to the right and up on each face of the cross.
Eigen::Vector3d right_on(int face) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY();
  return std::array{
      y, Eigen::Vector3d(-x), y, Eigen::Vector3d(-y), x, y}[static_cast<std::size_t>(face)];
}
Eigen::Vector3d up_on(int face) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();
  return std::array{z, z, Eigen::Vector3d(-x), z, z, x}[static_cast<std::size_t>(face)];
}

}  // namespace

SkinCross::SkinCross(int face_points)
    : face_points_(face_points),
      grid_(static_cast<std::size_t>(kCrossWidth * kCrossHeight * face_points * face_points), -1) {
  for (const auto& [face, row, column] : skin_cells(face_points)) {
    const CrossFace& at = kCross[static_cast<std::size_t>(face)];
    const Eigen::Vector3d middle = on_cube(face, row + 0.5, column + 0.5, face_points);
    const double right = (1 + middle.dot(right_on(face))) / 2 * face_points - 0.5;
    const double down = (1 - middle.dot(up_on(face))) / 2 * face_points - 0.5;
    const auto x = at.x * face_points + std::lround(right);
    const auto y = at.y * face_points + std::lround(down);
    grid_[static_cast<std::size_t>(y * kCrossWidth * face_points + x)] =
        static_cast<int>(cells_.size());
    cells_.push_back(Eigen::Vector2d(static_cast<double>(x), static_cast<double>(y)) / face_points);
  }
}

int SkinCross::afferent(const Eigen::Vector2d& place) const {
  const double x = std::floor(place.x() * face_points_), y = std::floor(place.y() * face_points_);
  const int width = kCrossWidth * face_points_, height = kCrossHeight * face_points_;
  if (!(x >= 0 && x < width && y >= 0 && y < height)) return -1;
  return grid_[static_cast<std::size_t>(y * width + x)];
}

Eigen::Matrix3d body_rotation(const LitterView& litter, int pup) {
  const std::vector<Eigen::Vector3d> rest = cube_sphere(litter.params.face_points, 1);
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  for (int i = 0; i < litter.points; ++i) {
    moment += litter.positions(pup, i) * rest[static_cast<std::size_t>(i)].transpose();
  }
  if (!moment.allFinite()) return Eigen::Matrix3d::Identity();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0) signs.z() = -1;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

/// Undoes the map of cube_sphere (geometry.h). On the face where x = 1, with y and z on the cube and
/// y', z' on the sphere,
///
///   y'^2 = y^2 / 2 - y^2 z^2 / 6,    z'^2 = z^2 / 2 - y^2 z^2 / 6,
///
/// so that y^2 - z^2 = d = 2 (y'^2 - z'^2), and z^2 is the smaller root of
/// t^2 - (3 - d) t + 6 z'^2.
int afferent_towards(const Eigen::Vector3d& direction, int face_points) {
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  const double side = direction[axis] < 0 ? -1 : 1;
  const double u = side * direction[(axis + 1) % 3], v = side * direction[(axis + 2) % 3];
  const double d = 2 * (u * u - v * v), b = 3 - d;
  const double vv = (b - std::sqrt(std::max(b * b - 24 * v * v, 0.0))) / 2;
  const auto line = [&](double square, double sign) {
    const double place = std::copysign(std::sqrt(std::max(square, 0.0)), sign);
    return std::clamp(static_cast<int>((place + 1) / 2 * face_points), 0, face_points - 1);
  };
  const int face = static_cast<int>(axis) + (side < 0 ? 3 : 0);
  return (face * face_points + line(vv + d, u)) * face_points + line(vv, v);
}

HeadingDisc::HeadingDisc(int face_points, int size) : face_points_(face_points), size_(size) {
  afferents_.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), -1);
  const auto middle = [&](int pixel) { return (2 * pixel + 1.0) / size - 1; };
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const double right = middle(column), up = -middle(row);
      const double square = right * right + up * up;
      if (square > 1) continue;
      const double stretch = 2 * std::sqrt(1 - square);
      inside_.push_back({static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                             static_cast<std::size_t>(column),
                         {1 - 2 * square, stretch * right, stretch * up}});
    }
  }
}

void HeadingDisc::update(const Eigen::Matrix3d& rotation, double heading) {
  Eigen::Matrix3d ahead_right_up;
  ahead_right_up << std::cos(heading), std::sin(heading), 0,  //
      std::sin(heading), -std::cos(heading), 0,               //
      0, 0, 1;
  const Eigen::Matrix3d to_body = (ahead_right_up * rotation).transpose();
  for (const auto& [place, direction] : inside_) {
    afferents_[place] = afferent_towards(to_body * direction, face_points_);
  }
}

}  // namespace pupflow::view
