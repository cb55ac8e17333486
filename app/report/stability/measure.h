// Measurements of the stability report: the deformation of bodies, and how fast they move.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/bodies.h"

namespace pupflow::report {

/// The shape and motion of one pup at one time.
struct Shape {
  /// Deformation energy (Pose, engine/bodies.h): 0 at rest; 1 is a displacement of every point by a
  /// radius. Up to a factor the potential energy of springs that pull points to rigid goals.
  double energy = 0;
  /// Determinant of the fitted linear map: 1 at rest; 0 flat; below 0 inverted.
  double volume = 1;
  /// Mean over points of |v|^2 / 2: kinetic energy by mass, in arena units^2 / s^2.
  double kinetic = 0;
  /// The deformation in the body's frame: R^T F - identity, with R and F of the pose.
  Eigen::Matrix3d strain = Eigen::Matrix3d::Zero();
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};

/// Measures litters with given parameters many times.
class ShapeGauge {
 public:
  explicit ShapeGauge(const Params& params) : rest_(rest_points(params)) {}

  /// The shapes of all pups, in order. Valid until the next call.
  const std::vector<Shape>& measure(const LitterView& litter);

 private:
  Points rest_;
  std::vector<Shape> shapes_;
};

/// The same once.
std::vector<Shape> shapes_of(const LitterView& litter);

}  // namespace pupflow::report
