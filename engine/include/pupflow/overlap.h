// How far the bodies of a litter run into each other: distance of centres, and points of one pup
// inside another.
//
// A point is inside a body when the winding number of the body's closed surface round it is above
// 1/2 (Jacobson, Kavan & Sorkine-Hornung 2013, Robust inside-outside segmentation using
// generalized winding numbers). The surface runs through the pup's points (surface_triangles,
// geometry.h). For a closed surface the number is whole: a ray from the point leaves the surface so
// many times more than it enters. Counting that is exact and needs no angle.
#pragma once

#include <cstdint>
#include <memory>

#include "pupflow/geometry.h"
#include "pupflow/view.h"

namespace pupflow {

/// How the bodies overlap after one step. Without a second pup the distances are infinite.
struct Overlap {
  double nearest = 0;         // distance to the nearest other centre, mean over pups
  double least = 0;           // the smallest of these distances
  double inside = 0;          // share of all points that lie inside another body
  double inside_exposed = 0;  // share of those that touch nobody, so count as exposed; 0 if none
};

/// Measures litters of any kind, one after another, and keeps its memory in between.
class OverlapMeter {
 public:
  OverlapMeter();
  OverlapMeter(OverlapMeter&&) noexcept;
  OverlapMeter& operator=(OverlapMeter&&) noexcept;
  ~OverlapMeter();

  /// The litter as it stands. Whether a point touches somebody is what the last step found, so the
  /// simulation must be observed (Simulation::set_observed). Positions must be finite. For twelve
  /// pups in a huddle it takes as long as some ten steps.
  Overlap measure(const LitterView& litter);

 private:
  class Memory;
  std::unique_ptr<Memory> memory_;
};

/// The same for a single look.
Overlap measure_overlap(const LitterView& litter);

/// Means over the looks of a run: of `inside_exposed` weighted by `inside`, so over points.
class OverlapMeans {
 public:
  void add(const Overlap& overlap);
  std::int64_t count() const { return count_; }
  /// `least` is the smallest of all looks. All NaN without a look.
  Overlap means() const;

 private:
  std::int64_t count_ = 0;
  Overlap sum_;
};

}  // namespace pupflow
