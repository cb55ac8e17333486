// Contacts between pups.
//
// Two points of different pups, r being the point radius, touch when
//
//   d = |p_a - p_b| < 2 r
//
// Only the upper of the two moves, from the positions before this stage:
//
//   contact = nearest   p_a <- p_a + (p_a - p_b) (2 r - d)
//                       v_a <- p_b - p_a
//
//   contact = mean      p_a <- p_a + mean of (p_a - p_b) (2 r - d)
//                       v_a <- mean of (p_b - p_a)
//
//   contact = sum       p_a <- p_a + sum of (p_a - p_b) (2 r - d)
//                       v_a <- mean of (p_b - p_a)
//
// where b is the nearest touching lower point, and mean and sum are over all touching lower points
// b. At equal heights the point of the lower pup index is the upper one. At equal distances the
// point of the lower pup, then that of the lower point index, is the nearest. A point's nearest
// touching point, upper or lower, says whose temperature its afferent feels. Wilson 2017, Methods;
// docs/model.md, Contacts.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/broad_phase.h"
#include "engine/near.h"
#include "engine/state.h"
#include "engine/team.h"
#include "pupflow/parameters.h"
#include "pupflow/status.h"

namespace pupflow {

/// What contacts write into State besides moving points (plan.h says who reads it). What is not
/// asked for stays as it was.
struct ContactRecords {
  bool exposure = true;  // `exposed` and `touching_points`
  bool owners = true;    // `touched` of the points that have a contact
  bool pairs = true;     // `touching`, and `touched` = -1 of the points without contact
};

/// The contact stage and its working memory: first `find` for the litter, then `apply` for each
/// pup.
template <class Real>
class Contacts {
 public:
  /// Finds all contacts of `state`, whose bounds must enclose the points, and fills the list of
  /// touching pairs if `records` asks for it; `apply` fills the rest. The workers of `team` share
  /// the pairs of pups. No sum depends on how many workers there are.
  void find(const Params& params, ContactRecords records, State<Real>& state, Team& team);

  /// How many near pairs the last `find` compared point by point. In the other near pairs the balls
  /// round the pups are too far apart.
  std::int64_t searched_pairs() const;

  /// Moves the points of `pup` that have contacts, with `factor` times the displacement (1 except
  /// in a refined step, refinement.h), and fills the records of this pup. Its bounds no longer
  /// enclose its points. Different workers of the team may do different pups at the same time.
  /// Returns a bad status where a point has moved out of all proportion.
  Status apply(const Params& params, double factor, State<Real>& state, int pup, int worker);

 private:
  static constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

  /// The contacts of one point with one other pup.
  struct Touch {
    int point;
    Real nearest;  // squared distance of the nearest touching point
    // With ContactRule::nearest:
    Real lower;     // squared distance of the nearest touching lower point; infinite without one
    Real apart[3];  // p_a - p_b, b being that point
  };
  /// With the other rules also, of all its touching lower points:
  struct Sums {
    Real movers = 0;                   // how many
    Real displacement[3] = {0, 0, 0};  // sum of (p_a - p_b)(2 r - d)
    Real velocity[3] = {0, 0, 0};      // sum of (p_b - p_a)
  };
  /// All contacts of one point.
  struct Contact {
    Real nearest = kInfinity, lower = kInfinity;
    int owner = -1;                // the pup of the nearest touching point
    const Touch* mover = nullptr;  // that with the nearest lower point
  };
  /// Working memory of one worker.
  struct Scratch {
    NearPoints<Real> first, second;  // of the pair whose points are being compared
    Comparison<Real> comparison;
    std::int64_t searched;       // pairs, in this step
    std::vector<Touch> touches;  // of all its pairs, one after the other: the first `used`
    int used;
    std::vector<Sums> sums;  // of the same
    // Of the pup that is being moved:
    std::vector<Contact> contacts;    // by point
    std::vector<Sums> total;          // by point
    std::vector<std::uint64_t> bits;  // the points that have a contact
  };
  /// The touches begin ... end - 1 of one worker: those of one pup with another.
  struct TouchRange {
    int worker, begin, end;
    int other;  // the other pup
  };
  /// The touches of both pups of a near pair. Both are empty when the pups do not touch.
  struct PairTouches {
    TouchRange first, second;
  };

  void make_room(const State<Real>& state, int workers, std::size_t pairs);
  bool touch_pair(const State<Real>& state, NearPair pair, Scratch& mine) const;
  TouchRange record(const NearPoints<Real>& points, const NearPoints<Real>& partners, int other,
                    int worker);
  void sort_by_pup(const std::vector<NearPair>& pairs, State<Real>& state);
  void join(const TouchRange& range, Scratch& mine) const;
  bool move_point(int point, Scratch& mine, Real factor, Real suspect, std::size_t i,
                  State<Real>& state) const;

  ContactRule rule_ = ContactRule::nearest;  // of this step
  ContactRecords records_;                   // of this step
  Real reach_ = 0;                           // 2 r
  BroadPhase<Real> broad_phase_;
  std::vector<Scratch> scratch_;           // one per worker
  std::vector<PairTouches> pair_touches_;  // one per near pair
  // The touches of pup j, in the order of pairs: ranges_[ends_[j - 1]] ... ranges_[ends_[j] - 1].
  std::vector<TouchRange> ranges_;
  std::vector<int> ends_;
};

}  // namespace pupflow
