#include "app/report/stability/measure.h"

#include <Eigen/LU>

namespace pupflow::report {

const std::vector<Shape>& ShapeGauge::measure(const LitterView& litter) {
  shapes_.clear();
  for (int pup = 0; pup < litter.pups; ++pup) {
    const Pose pose = pose_of(of_pup(litter.positions, pup), rest_);
    Shape shape;
    shape.energy = pose.energy;
    shape.volume = pose.map.determinant();
    for (int i = 0; i < litter.points; ++i) {
      shape.kinetic += litter.velocities(pup, i).squaredNorm() / (2.0 * litter.points);
    }
    shape.strain = pose.rotation.transpose() * pose.map - Eigen::Matrix3d::Identity();
    shape.centre = pose.centre;
    shapes_.push_back(shape);
  }
  return shapes_;
}

std::vector<Shape> shapes_of(const LitterView& litter) {
  return ShapeGauge(litter.params).measure(litter);
}

}  // namespace pupflow::report
