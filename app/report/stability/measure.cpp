#include "app/report/stability/measure.h"

#include <Eigen/LU>

#include "engine/rotation.h"
#include "pupflow/geometry.h"

namespace pupflow::report {

using Eigen::Matrix3d;
using Eigen::Vector3d;

ShapeGauge::ShapeGauge(const Params& params)
    : radius_(params.pup_radius), rest_(cube_sphere(params.face_points, params.pup_radius)) {
  for (const Vector3d& q : rest_) squares_ += q.x() * q.x();
}

const std::vector<Shape>& ShapeGauge::look(const Simulation& simulation) {
  const std::size_t points = rest_.size();
  xyz_.resize(3 * points * static_cast<std::size_t>(simulation.pups()));
  simulation.copy_positions(std::span<double>(xyz_));
  velocities_.resize(xyz_.size());
  simulation.copy_velocities(velocities_);
  shapes_.assign(static_cast<std::size_t>(simulation.pups()), {});
  for (std::size_t pup = 0; pup < shapes_.size(); ++pup) {
    Shape& shape = shapes_[pup];
    const Eigen::Map<const Eigen::Matrix3Xd> x(xyz_.data() + 3 * points * pup, 3,
                                               static_cast<Eigen::Index>(points));
    shape.centre = x.rowwise().mean();
    Matrix3d map = Matrix3d::Zero();
    for (std::size_t i = 0; i < points; ++i) {
      map += (x.col(static_cast<Eigen::Index>(i)) - shape.centre) * rest_[i].transpose();
    }
    map /= squares_;
    const Matrix3d rotation = nearest_rotation(map).matrix;
    for (std::size_t i = 0; i < points; ++i) {
      shape.energy +=
          (x.col(static_cast<Eigen::Index>(i)) - shape.centre - rotation * rest_[i]).squaredNorm();
    }
    shape.energy /= static_cast<double>(points) * radius_ * radius_;
    const Eigen::Map<const Eigen::Matrix3Xd> v(velocities_.data() + 3 * points * pup, 3,
                                               static_cast<Eigen::Index>(points));
    shape.kinetic = v.squaredNorm() / (2 * static_cast<double>(points));
    shape.volume = map.determinant();
    shape.strain = rotation.transpose() * map - Matrix3d::Identity();
  }
  return shapes_;
}

std::vector<Shape> shapes_of(const Simulation& simulation) {
  return ShapeGauge(simulation.params()).look(simulation);
}

}  // namespace pupflow::report
