/// @file
/// How far the bodies of a litter overlap: distances of centres, and points of one pup inside
/// another.
///
/// A point is inside a body when the winding number of the body's closed surface round it is above
/// 1/2 (Jacobson, Kavan & Sorkine-Hornung 2013, Robust inside-outside segmentation using
/// generalized winding numbers). The surface goes through the pup's points (surface_triangles,
/// geometry.h). For a closed surface the winding number is a whole number, along any ray from the
/// point:
///
///   winding number = (times the ray leaves the surface) - (times it enters)
///
/// This count is exact and needs no angles.
#pragma once

#include <cstdint>
#include <memory>

#include "pupflow/geometry.h"
#include "pupflow/view.h"

#pragma GCC visibility push(default)
namespace pupflow {

/// How the bodies overlap after one step. Without a second pup the distances are infinite.
struct Overlap {
  double nearest = 0;         ///< distance to the nearest other centre, mean over pups
  double least = 0;           ///< the smallest of these distances
  double inside = 0;          ///< share of all points that lie inside another body
  double inside_exposed = 0;  ///< share of those points that are exposed; 0 if none inside
};

/// Measures one litter after another, of any size, and keeps its memory in between.
class OverlapMeter {
 public:
  OverlapMeter();

  /// The other one may then only be destroyed or assigned to.
  ///@{
  OverlapMeter(OverlapMeter&&) noexcept;
  OverlapMeter& operator=(OverlapMeter&&) noexcept;
  ///@}

  ~OverlapMeter();

  /// The overlap of the litter now. The contacts of points are those of the last step, so the
  /// simulation must be observed (Simulation::set_observed). Positions must be finite. For twelve
  /// pups in a huddle it takes as long as some ten steps.
  Overlap measure(const LitterView& litter);

 private:
  class Memory;
  std::unique_ptr<Memory> memory_;
};

/// The same for one litter.
Overlap measure_overlap(const LitterView& litter);

/// Means over the overlaps of a run. That of `inside_exposed` is weighted by `inside`, so it is a
/// mean over points.
class OverlapMeans {
 public:
  /// Adds what was measured after a step.
  void add(const Overlap& overlap);

  /// How many were added.
  std::int64_t count() const { return count_; }

  /// `least` is the smallest of all added. All are NaN before the first `add`.
  Overlap means() const;

 private:
  std::int64_t count_ = 0;
  Overlap sum_;
};

}  // namespace pupflow
#pragma GCC visibility pop
