// Stage 2 of a step: contacts between pups.
//
// Two points of different pups touch when d = |p_a - p_b| < 2 r. Only the upper one moves. For an
// upper point a over all its touching lower points b, from the positions before this stage: p_a <-
// p_a + sum (p_a - p_b)(2 r - d), v_a <- mean of (p_b - p_a). At equal heights the point of the
// lower pup index is the upper one. A point's nearest touching point (at equal distances that of
// the lower pup, then point, index) says whose temperature its afferent feels. Wilson 2017,
// Methods.
#pragma once

#include <vector>

#include "engine/broad_phase.h"
#include "engine/params.h"
#include "engine/state.h"
#include "engine/status.h"

namespace pupflow {

/// The contact stage and its working memory.
template <class Real>
class Contacts {
 public:
  /// Finds and resolves all contacts of `state`, whose bounds must be true. Fills `touching`, and,
  /// with `afferents`, `touched` and `exposed`. Bounds of pups that were moved are no longer true.
  Status resolve(const Params& params, bool afferents, State<Real>& state);

 private:
  /// The points of one pup that may touch another, and what their contacts come to.
  struct Side {
    AlignedVector<Real> numbers;  // of all arrays below
    std::vector<int> point;
    Candidates<Real> candidates;
    ContactSums<Real> sums;
    void make_room(int stride);
  };
  /// What a point's contacts add up to.
  struct Touch {
    Real push[3];  // sum of (p_a - p_b)(2 r - d) where this point is the upper one
    Real pull[3];  // sum of (p_b - p_a) there
    Real uppers;   // contacts in which this point is the upper one
    Real nearest;  // squared distance to the nearest touching point
    int owner;     // pup of that point, -1 before the first contact
  };

  bool touch_pair(const State<Real>& state, TouchingPair pair, Real reach);
  void merge(const Side& side, std::size_t row, int other);
  Status apply(const Params& params, State<Real>& state);
  void report(State<Real>& state) const;

  BroadPhase<Real> broad_phase_;
  Side first_, second_;
  std::vector<Touch> touch_;       // one per point, padding included
  std::vector<std::size_t> list_;  // points with a contact, in the order of their first
};

}  // namespace pupflow
