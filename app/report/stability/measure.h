// What the stability report measures on a litter: how far bodies are from their rest shape, and
// how fast they move.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "pupflow/simulation.h"

namespace pupflow::report {

/// The shape of one pup at one time, whatever its place and rotation.
struct Shape {
  /// Mean over points of |x - c - R q|^2 / r_pup^2: squared distance from the rest shape q, turned
  /// by the rotation R nearest to the fitted linear map. 0 at rest; 1 is a displacement of every
  /// point by a radius. The potential energy of the springs that pull points to rigid goals, up to
  /// a factor.
  double energy = 0;
  /// Determinant of the fitted linear map of the rest offsets: 1 at rest, the volume's factor; 0
  /// flat, below 0 turned inside out.
  double volume = 1;
  /// Mean over points of |v|^2 / 2: kinetic energy by mass, in arena units^2 / s^2.
  double kinetic = 0;
  /// The deformation's coordinates in the body's frame: R^T (fitted map) - identity, nine numbers.
  Eigen::Matrix3d strain = Eigen::Matrix3d::Zero();
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};

/// Looks at litters with given parameters, again and again.
class ShapeGauge {
 public:
  explicit ShapeGauge(const Params& params);

  /// The shapes of all pups, one after the other; they stay until the next look.
  const std::vector<Shape>& look(const Simulation& simulation);

 private:
  double radius_, squares_ = 0;  // sum of x^2 over the rest offsets
  std::vector<Eigen::Vector3d> rest_;
  std::vector<double> xyz_, velocities_;
  std::vector<Shape> shapes_;
};

/// The same for one look.
std::vector<Shape> shapes_of(const Simulation& simulation);

}  // namespace pupflow::report
