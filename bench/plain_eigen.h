// Baseline: the step of docs/model.md as a competent programmer writes it with Eigen and does not
// tune it: an array of point structures per pup, a box round each pup, squared distances compared,
// rotations from Eigen's JacobiSVD.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bench/outcome.h"
#include "pupflow/parameters.h"

namespace pupflow::bench {

/// A litter stepped in that way, in float or double.
template <class Real>
class PlainEigen {
 public:
  /// Goes on from `start`. Throws std::invalid_argument as require_baseline_model does.
  explicit PlainEigen(const Snapshot& start);

  void step();
  Outcome outcome() const;

 private:
  using Vector = Eigen::Matrix<Real, 3, 1>;
  using Modes = Eigen::Matrix<Real, 9, 1>;  // x, y, z, x^2, y^2, z^2, xy, yz, zx

  struct Point {
    Vector position, velocity;
    int touched = -1;                 // pup of the nearest touching point, or -1
    Real nearest = 0;                 // squared distance to it
    bool moves = false;               // some touching point is lower
    Real lower = 0;                   // squared distance to the nearest of those
    Vector partner = Vector::Zero();  // its position
  };
  struct Pup {
    std::vector<Point> points;
    Vector low, high;
    double tb, heading, exposed;
  };

  void floor_and_wall(Pup& pup) const;
  void measure_box(Pup& pup) const;
  std::vector<int> points_near(const Pup& pup, const Pup& other) const;
  void contacts();
  bool search_pair(int first, int second);
  static void meet(Point& upper, const Point& lower, Real squared);
  void resolve_contacts(Pup& pup) const;
  void steer(Pup& pup) const;
  void warm();
  void predict(Pup& pup) const;
  void match_shape(Pup& pup) const;
  Eigen::Matrix<Real, 3, 9> goal_map(const Pup& pup, const Vector& centre) const;

  Params params_;
  std::vector<Pup> pups_;
  std::vector<Modes, Eigen::aligned_allocator<Modes>> rest_;  // less their mean
  Eigen::Matrix<Real, 9, 9> rest_inverse_;                    // pseudo-inverse of sum q q^T
  std::vector<TouchingPair> touching_;
};

}  // namespace pupflow::bench
