// Stage 2 of a step: contacts between pups.
//
// Two points of different pups touch when d = |p_a - p_b| < 2 r. Only the upper one moves. For an
// upper point a over all its touching lower points b, from the positions before this stage: p_a <-
// p_a + sum (p_a - p_b)(2 r - d), v_a <- mean of (p_b - p_a). At equal heights the point of the
// lower pup index is the upper one. A point's nearest touching point (at equal distances that of
// the lower pup, then point, index) says whose temperature its afferent feels. Wilson 2017,
// Methods.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "engine/broad_phase.h"
#include "engine/params.h"
#include "engine/state.h"
#include "engine/status.h"
#include "engine/team.h"

namespace pupflow {

/// The contact stage and its working memory: first `find` for the litter, then `apply` for each
/// pup.
template <class Real>
class Contacts {
 public:
  /// Finds all contacts of `state`, whose bounds must be true. Fills `touching`, and, with
  /// `afferents`, `touched`. The workers of `team` share the pups; every sum is made by one of
  /// them, in the order of pairs, so that results do not depend on how many there are.
  void find(const Params& params, bool afferents, State<Real>& state, Team& team);

  /// Moves the points of `pup`, by `share_of_push` of what contacts displace them (1 but with a
  /// refined step, refinement.h), and, with `afferents`, fills its `exposed`. Its bounds are no
  /// longer true. Different pups may be done at the same time.
  Status apply(const Params& params, double share_of_push, bool afferents, State<Real>& state,
               int pup);

 private:
  /// The points of one pup that may touch another, and what their contacts come to.
  struct Side {
    AlignedVector<Real> numbers;  // of all arrays below
    std::vector<int> point;
    std::vector<std::uint64_t> touching;
    Candidates<Real> candidates;
    ContactSums<Real> sums;
    void make_room(int stride);
  };
  struct Worker {
    Side first, second;
  };
  /// What a point's contacts add up to.
  struct Touch {
    Real push[3] = {0, 0, 0};  // sum of (p_a - p_b)(2 r - d) where this point is the upper one
    Real uppers = 0;           // contacts in which this point is the upper one
    Real pull[3] = {0, 0, 0};  // sum of (p_b - p_a) there
    Real nearest = std::numeric_limits<Real>::infinity();  // squared, to the nearest touching point
  };

  void make_room(const State<Real>& state, int workers);
  bool touch_pair(const State<Real>& state, TouchingPair pair, Real reach, Worker& worker) const;
  void merge(const Side& side, int pup, int other, bool afferents, State<Real>& state);

  BroadPhase<Real> broad_phase_;
  std::vector<Worker> workers_;
  std::vector<int> owner_;           // the worker of each pup
  std::vector<char> touches_;        // for each near pair: whether it touches
  std::vector<Touch> touch_;         // one per point, padding included
  std::vector<std::uint64_t> bits_;  // the points with a contact; words_for(points) per pup
};

}  // namespace pupflow
