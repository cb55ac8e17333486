/// @file
/// The only way to look at a litter from outside. A simulation, a snapshot and a copy each give a
/// LitterView; everything that writes, draws or measures reads one.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pupflow/parameters.h"
#include "pupflow/plan.h"

#pragma GCC visibility push(default)
namespace pupflow {

/// Two pups that touched in the last step, first < second.
struct TouchingPair {
  int first;   ///< the pup of the lower number
  int second;  ///< the other one
  friend bool operator==(const TouchingPair&, const TouchingPair&) = default;
};

/// Where a pup is and how it is turned.
struct PupPose {
  std::array<double, 3> centre;      ///< mean over the points, arena units
  std::array<double, 4> quaternion;  ///< x y z w, w >= 0: from body axes to those of the arena
};

/// One 3-vector per point, pup by pup, in memory that belongs to someone else: positions or
/// velocities, in float or double.
class PointVectors {
 public:
  /// No vectors.
  PointVectors() = default;

  /// x0 y0 z0 x1 ..., pup by pup: 3 * pups * points numbers.
  ///@{
  PointVectors(std::span<const float> xyz, int pups, int points);
  PointVectors(std::span<const double> xyz, int pups, int points);
  ///@}

  /// An array per component: point i of pup j is element j * stride + i.
  ///@{
  PointVectors(const float* x, const float* y, const float* z, int pups, int points, int stride);
  PointVectors(const double* x, const double* y, const double* z, int pups, int points, int stride);
  ///@}

  int pups() const { return pups_; }         ///< number of pups
  int points() const { return points_; }     ///< per pup
  bool empty() const { return pups_ == 0; }  ///< whether there is no vector

  /// The vector of a point.
  /// Both indices must be in range.
  Eigen::Vector3d operator()(int pup, int point) const;

  /// Mean over the points of a pup. Throws std::out_of_range for a pup that is not there.
  Eigen::Vector3d mean(int pup) const;

  /// Writes all vectors, or those of one pup, as x0 y0 z0 x1 .... Throw std::invalid_argument
  /// unless `xyz` has room for exactly 3 numbers a vector.
  ///@{
  void copy_to(std::span<float> xyz) const;
  void copy_to(std::span<double> xyz) const;
  void copy_pup_to(int pup, std::span<float> xyz) const;
  void copy_pup_to(int pup, std::span<double> xyz) const;
  ///@}

 private:
  template <class Real, class Use>
  void for_each(int first, int last, const Use& use) const;
  template <class Use>
  void visit(int first, int last, const Use& use) const;
  template <class Out>
  void copy(int first, int last, std::span<Out> xyz) const;

  const void* component_[3] = {nullptr, nullptr, nullptr};
  bool is_double_ = true;
  int pups_ = 0, points_ = 0;
  std::ptrdiff_t step_ = 0, row_ = 0;  // numbers from a point, or a pup, to the next
};

/// A litter as it is after some step, in memory that belongs to someone else: it is valid until
/// that changes.
///
/// What the last step found is known as far as it was observed (Simulation::set_observed):
/// `recorded` says which parts of the step computed it.
struct LitterView {
  const Params& params;     ///< those of the last step
  const Params& recipe;     ///< those of the start, with the schedule: what makes the litter again
  int pups = 0;             ///< number of pups
  int points = 0;           ///< per pup
  PointVectors positions;   ///< arena units
  PointVectors velocities;  ///< arena units per second; may be empty in a copy

  // One value per pup.
  std::span<const double> tb;       ///< body temperature T_b
  std::span<const double> felt_tb;  ///< T_b before the heat stage of the last step
  std::span<const double> heading;  ///< direction of travel theta, in (-pi, pi]
  std::span<const double> exposed;  ///< Part::exposure: share A of the points without contact

  // Part::sides: what steering felt in the last step; one value per pup. Empty unless recorded.
  std::span<const double> t_left;   ///< mean T_c on the left
  std::span<const double> t_right;  ///< mean T_c on the right
  std::span<const double> turn;     ///< delta theta, radians; fields.h has the equation

  std::span<const PupPose> pose;  ///< Part::pose, one per pup; or empty

  // One value per afferent (point), pup by pup.
  std::span<const int> touched;        ///< Part::owners, Part::pairs: pup of the nearest touching
                                       ///< point, or -1
  std::span<const std::uint8_t> left;  ///< Part::sides: 1 on the left of the heading; or empty
  std::span<const float> strain;  ///< Part::strain: distance from the goal, arena units; or empty

  std::span<const TouchingPair> touching;  ///< Part::pairs: sorted
  std::int64_t step = 0;                   ///< steps done
  double time = 0;                         ///< model seconds
  PartSet recorded;                        ///< the parts that the last step recorded
};

/// A litter's view with memory of its own, for handing to another thread. Points are copied as
/// float; what the last step did not record is left out. Memory is reused from copy to copy.
class LitterCopy {
 public:
  /// Copies `litter`; velocities only where they are wanted.
  void take(const LitterView& litter, bool velocities);

  /// The copy. Valid until the next `take`. Before the first it has no pup.
  LitterView view() const;

 private:
  Params params_, recipe_;
  int pups_ = 0, points_ = 0;
  std::vector<float> positions_, velocities_, strain_;
  std::vector<double> tb_, felt_tb_, heading_, exposed_, t_left_, t_right_, turn_;
  std::vector<PupPose> pose_;
  std::vector<int> touched_;
  std::vector<std::uint8_t> left_;
  std::vector<TouchingPair> touching_;
  std::int64_t step_ = 0;
  double time_ = 0;
  PartSet recorded_;
};

}  // namespace pupflow
#pragma GCC visibility pop
