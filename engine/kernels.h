// The loops over points, compiled once for each instruction set and chosen when a litter is made.
// All versions give the same bits: packs have one width and one order of folding (lanes.h), and
// nothing is contracted.
#pragma once

#include <cstdint>

#include "pupflow/instruction_set.h"

namespace pupflow {

/// Where to look for points: inside a ball and a box.
template <class Real>
struct Region {
  Real centre[3], radius;
  Real low[3], high[3];
};

/// Points copied side by side for a search: coordinates, and where they came from.
template <class Real>
struct Candidates {
  Real *x, *y, *z;  // room for a pack more than there are points
  int* point;       // and for 64 bytes more
  int count;
};

/// The contacts of each candidate with the other pup's candidates.
template <class Real>
struct CandidateContacts {
  Real* nearest;  // squared distance to the nearest touching point; infinite without contact
  std::uint64_t* touching;  // bit i is set where candidate i has a contact
  // By touch_nearest:
  Real* lower;    // squared distance to the nearest touching point below; infinite where none is
  Real* partner;  // index of that point among the other pup's candidates: a whole number
  // By touch_sums:
  Real *push[3],
      *pull[3];  // sums of (p_a - p_b)(reach - d) and of (p_b - p_a) where it is the upper one
  Real* uppers;  // how many contacts those are
};

/// Arrays hold `stride` numbers (lanes.h). xyz are three such rows. Functions that take `points`
/// leave the padding out; a cloud's second half mirrors the first (cloud.h).
template <class Real>
struct Kernels {
  /// Box round the first `points` points, its middle, and the largest distance from there. False
  /// when a coordinate is not finite.
  bool (*bounds)(const Real* const xyz[3], int points, Real low[3], Real high[3], Real centre[3],
                 Real* radius);
  /// v_z <- |v_z|, z <- r where z < r.
  void (*floor)(Real r, int stride, Real* z, Real* vz);
  /// v <- v + gain, x <- x + h v.
  void (*predict)(Real h, Real gain, int points, Real* x, Real* v);
  /// sums[m] = sum over points of mode m times (xyz - first point), for modes 0 ... count - 1 of
  /// `modes`.
  void (*fit)(const Real* modes, int count, int points, int stride, const Real* const xyz[3],
              Real sums[][3]);
  /// With d = sum of goal[m] mode[m] - (x - x[0]): x <- x + position_share d, v <- v +
  /// velocity_share d.
  void (*pull)(const Real* modes, int count, int points, int stride, const Real* goal,
               Real position_share, Real velocity_share, Real* x, Real* v);
  /// With d = sum of goal[m] mode[m] - stiffness (x - x[0]) - drag (v - v[0]): x <- x + d, v <- v +
  /// rate d.
  void (*pull_damped)(const Real* modes, int count, int points, int stride, const Real* goal,
                      Real stiffness, Real drag, Real rate, Real* x, Real* v);
  /// Sum of a[i] b[i].
  Real (*dot)(const Real* a, const Real* b, int stride);
  /// Sets the bits of `words` (as many as `points` points need) where cosine (y - cy) - sine (x -
  /// cx) > 0.
  void (*left)(const Real* x, const Real* y, int points, Real cx, Real cy, Real cosine, Real sine,
               std::uint64_t* words);
  /// Copies the points inside the region to `out`, in order, and pads them with points far away.
  void (*gather)(const Real* const xyz[3], int points, const Region<Real>& region,
                 Candidates<Real>& out);
  /// The box round some candidates, at least one.
  void (*box)(const Candidates<Real>& candidates, Real low[3], Real high[3]);
  /// Contacts between two pups' candidates: pairs nearer than `reach`. At equal heights `a` is the
  /// upper one; at equal distances the candidate of the lower index is the nearer one. Returns
  /// whether there is any; only then is the result complete. touch_nearest finds the nearest lower
  /// point of each candidate, touch_sums the sums over all of them.
  using FindTouching = bool(const Candidates<Real>& a, const Candidates<Real>& b, Real reach,
                            const CandidateContacts<Real>& contacts_a,
                            const CandidateContacts<Real>& contacts_b);
  FindTouching* touch_nearest;
  FindTouching* touch_sums;
};

/// The loops for one instruction set, which must be supported.
template <class Real>
const Kernels<Real>& kernels_for(InstructionSet set);

}  // namespace pupflow
