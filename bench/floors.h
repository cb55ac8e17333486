// The least that the arithmetic of some stages takes on this machine: tight kernels over the points
// of the huddling litter.
#pragma once

#include <vector>

#include "bench/tight.h"
#include "engine/aligned.h"
#include "engine/cloud.h"
#include "engine/state.h"
#include "pupflow/snapshot.h"

namespace pupflow::bench {

/// Microseconds a step; the work of all pups.
struct Floors {
  double predict = 0;
  double match = 0;      // quadratic shape matching without rotations
  double rotations = 0;  // the engine's, one a pup
  double bounds = 0;
  double distances = 0;  // of points that lie in each other's boxes, pair by pair
};

/// The arrays that tight kernels run over, and the time that they take.
template <class Real>
class TightLitter {
 public:
  explicit TightLitter(const Snapshot& state);

  /// Each kernel once over the litter, and its time.
  Floors measure(const TightKernels<Real>& kernels);

  /// How many pairs of points lie in each other's boxes.
  double distance_tests() const;

  /// What a contact search by groups of points cannot leave out.
  struct LeastSearch {
    double pups = 0;    // whose points are looked through, one after the other: two a near pair
    double points = 0;  // pairs of a point and a point of a group that it touches
  };
  /// Of groups of so many points.
  LeastSearch least_search(int group) const;

  int pups() const { return state_.pups; }

 private:
  struct Near {  // points of one pup that may touch another, in whole packs
    AlignedVector<Real> x, y, z;
    int count = 0;
  };
  TightPup<Real> pup(int number);
  Near near(int number, int other) const;

  Params params_;
  Cloud<Real> cloud_;
  State<Real> state_;
  std::vector<std::pair<Near, Near>> pairs_;
  std::vector<Eigen::Matrix3d> linear_;  // the linear part of each pup's fit
};

}  // namespace pupflow::bench
