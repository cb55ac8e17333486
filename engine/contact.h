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
  /// Points of one pup that may touch another pup, copied side by side.
  struct Candidates {
    AlignedVector<Real> x, y, z;
    std::vector<int> point;
    int count = 0;
  };
  /// What a point's contacts add up to.
  struct Touch {
    Real push[3];  // sum of (p_a - p_b)(2 r - d) where this point is the upper one
    Real pull[3];  // sum of (p_b - p_a) there
    Real nearest;  // squared distance to the nearest touching point
    int uppers;    // contacts in which this point is the upper one
    int owner;     // pup of the nearest touching point, -1 before the first contact
  };

  void gather(const State<Real>& state, int pup, const Box<Real>& other, Real margin,
              Candidates& candidates);
  bool touch_pair(const State<Real>& state, TouchingPair pair, Real reach);
  void add_contact(const State<Real>& state, TouchingPair pair, int a, int b, Real d_squared,
                   Real reach);
  void note(std::size_t point, int owner, Real d_squared);
  Status apply(const Params& params, State<Real>& state);
  void report(State<Real>& state) const;

  BroadPhase<Real> broad_phase_;
  Candidates first_, second_;
  std::vector<Touch> touch_;       // one per point, padding included
  std::vector<std::size_t> list_;  // points with a contact, in the order of their first
};

}  // namespace pupflow
