// Other methods for the rotation of shape matching, to compare with the engine's, and a weightless
// pup that is stepped with any of them.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>

#include "app/report/error/sampling.h"
#include "engine/bodies.h"

namespace pupflow::report {

/// Methods for the proper rotation nearest to a matrix. Those of Mueller 2016 start from the
/// rotation of the last step and take 1, 3 or 5 iterations.
enum class Routine {
  engine,       // nearest_rotation: Newton's iteration (Higham 1986)
  svd,          // Eigen's two-sided Jacobi singular values
  closed_form,  // A (A^T A)^(-1/2) with eigenvalues in closed form
  horn,         // largest eigenvector of Horn's 4 x 4 matrix (1987)
  mueller_1,
  mueller_3,
  mueller_5
};

/// Finds rotations by one routine, step after step.
class RotationFinder {
 public:
  explicit RotationFinder(Routine routine) : routine_(routine) {}
  Eigen::Matrix3d operator()(const Eigen::Matrix3d& a);

 private:
  Routine routine_;
  bool started_ = false;
  Eigen::Quaterniond last_;
};

/// Steps one weightless pup through `samples` times kSample as the engine does, with the rotation of
/// `routine` and without boundaries, bounds and checks. Calls `look` with points and velocities
/// after each kSample. Throws io::Failure(interrupted).
using LookAtPoints = std::function<void(const Points&, const Points&, Trajectory&)>;
Outcome run_with_rotation(const Params& params, Routine routine, const Points& points,
                          const Points& velocities, int samples, std::size_t quantities,
                          const LookAtPoints& look);

/// All routines at the default step; singular values at the same step are the reference.
Aside rotation_aside(const Params& params, std::vector<std::size_t> quantities);

}  // namespace pupflow::report
