// Stage 2 of a step: contacts between pups.
//
// Two points of different pups touch when d = |p_a - p_b| < 2 r. Only the upper one moves, from the
// positions before this stage:
//
//   contact = nearest   p_a <- p_a + (p_a - p_b)(2 r - d),          v_a <- p_b - p_a
//   contact = mean      p_a <- p_a + mean of (p_a - p_b)(2 r - d),  v_a <- mean of (p_b - p_a)
//   contact = sum       p_a <- p_a + sum of (p_a - p_b)(2 r - d),   v_a <- mean of (p_b - p_a)
//
// with b the nearest touching lower point, or over all touching lower points b. At equal heights
// the point of the lower pup index is the upper one; at equal distances the point of the lower pup,
// then of the lower point index, is the nearest. A point's nearest touching point, upper or lower,
// says whose temperature its afferent feels. Wilson 2017, Methods; docs/model.md, Contacts.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/broad_phase.h"
#include "engine/state.h"
#include "engine/team.h"
#include "pupflow/parameters.h"
#include "pupflow/status.h"

namespace pupflow {

/// What contacts record beside moving points (plan.h says who reads it).
struct ContactRecords {
  bool exposure = true;  // `exposed`, and `touching_points`
  bool owners = true;    // `touched` of the points that touch somebody
  bool pairs = true;     // `touching`, and -1 in `touched` for the points that touch nobody
};

/// The contact stage and its working memory: first `find` for the litter, then `apply` for each
/// pup.
template <class Real>
class Contacts {
 public:
  /// Finds all contacts of `state`, whose bounds must be true. `records` says what of the state
  /// this step fills: the list of pairs here, the rest in `apply`. What it does not say stays as it
  /// was. The workers of `team` share the pairs of pups; no sum depends on how many there are.
  void find(const Params& params, ContactRecords records, State<Real>& state, Team& team);

  /// Pairs of pups that the last `find` had to search point by point; the others were too far
  /// apart.
  std::int64_t searched_pairs() const;

  /// Moves the points of `pup`, by `share_of_push` of what contacts displace them (1 but with a
  /// refined step, refinement.h), and records what is wanted of them. Its bounds are no longer
  /// true. Different workers of the team may do different pups at a time.
  Status apply(const Params& params, double share_of_push, State<Real>& state, int pup, int worker);

 private:
  static constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

  /// The contacts of one point with one other pup, or with all.
  struct Touch {
    // Over those that move the point: its nearest lower point, or all lower points.
    Real push[3] = {0, 0, 0};  // sum of (p_a - p_b)(2 r - d)
    Real pull[3] = {0, 0, 0};  // sum of (p_b - p_a)
    Real movers = 0;           // how many they are
    Real lower = kInfinity;    // squared, to the nearest lower one; ContactRule::nearest only
    Real nearest = kInfinity;  // squared, to the nearest touching point
    int point = 0;
    int other = -1;  // the pup of that nearest point
  };
  /// The points of one pup that may touch another, and their contacts.
  struct Side {
    AlignedVector<Real> numbers;  // of all arrays below
    std::vector<int> point;
    std::vector<std::uint64_t> touching;
    Candidates<Real> candidates;
    CandidateContacts<Real> contacts;
    void make_room(int stride);
  };
  struct Worker {
    Side first, second;               // of the pair that is being searched
    std::int64_t searched;            // pairs, in this step
    std::vector<Touch> touches;       // of all pairs that it searched, one after the other
    std::vector<Touch> total;         // by point, of the pup that is being moved
    std::vector<std::uint64_t> bits;  // its points that touch somebody
  };
  /// The touches begin ... end - 1 of a worker are those of one pup with another.
  struct Range {
    int worker, begin, end;
  };
  /// Those of a pair: first those of its first pup. Both are empty when it does not touch.
  struct Found {
    Range first, second;
  };

  void make_room(const State<Real>& state, int workers, std::size_t pairs);
  bool touch_pair(const State<Real>& state, TouchingPair pair, Worker& worker) const;
  Touch touch_of(const Side& side, const Side& partners, int i) const;
  Range record(const Side& side, const Side& partners, int other, int worker,
               std::vector<Touch>& touches) const;
  void sort_by_pup(const std::vector<TouchingPair>& pairs, State<Real>& state);
  void add_up(std::span<const Touch> touches, Worker& mine) const;
  bool move_point(const Touch& touch, Real share, Real suspect, std::size_t i,
                  State<Real>& state) const;

  ContactRule rule_ = ContactRule::nearest;  // of this step
  ContactRecords records_;                   // of this step
  Real reach_ = 0;                           // 2 r
  BroadPhase<Real> broad_phase_;
  std::vector<Worker> workers_;
  std::vector<Found> found_;  // one per near pair
  // The ranges of pup j, in the order of pairs: ranges_[ends_[j - 1]] ... ranges_[ends_[j] - 1].
  std::vector<Range> ranges_;
  std::vector<int> ends_;
};

}  // namespace pupflow
