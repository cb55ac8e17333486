// The loops over points, compiled once for each instruction set and chosen when a litter is made.
// All versions give the same bits: packs have one width, their lanes are added in one order
// (lanes.h), and the compiler never joins a product and a sum into one operation.
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
  Real *x, *y, *z;  // with room for 16 numbers behind the last point
  int* point;       // with room for 64 bytes behind the last
  int count;
};

/// The contacts of each candidate with the other pup's candidates.
template <class Real>
struct CandidateContacts {
  Real* nearest;  // squared distance to the nearest touching point; infinite without contact
  std::uint64_t* touching;  // bit i is set where candidate i has a contact
  // Each row has room for 16 numbers behind the last candidate.
  // By touch_nearest:
  Real* lower;    // squared distance to the nearest touching point below; infinite where none is
  Real* partner;  // index of that point among the other pup's candidates: a whole number
  // By touch_sums:
  Real* displacement[3];  // sum of (p_a - p_b)(reach - d) over contacts where it is the upper one
  Real* velocity[3];      // sum of (p_b - p_a) over the same contacts
  Real* uppers;           // number of those contacts
};

/// Candidates, rounded: relative to some origin. Room as in Candidates.
struct RoughPoints {
  float* xyz[3];
  float* half_square;  // half of x^2 + y^2 + z^2
  float (*beside)[4];  // x, y, z and a limit, for each point
};

/// Working memory for finding what touches.
template <class Real>
struct TouchMemory {
  RoughPoints a, b;
  int *list, *kept;   // candidates of a, and 64 bytes
  std::uint8_t* met;  // one for each candidate of a
  Real* tiles;        // 8 packs for each candidate of a
};

/// Matrices that `rotations` takes together.
constexpr int kRotationLanes = 8;

/// Below this share of the largest possible determinant a cloud counts as flat.
constexpr double kFlatCloud = 1e-6;

/// Arrays hold `stride` numbers, a whole number of packs (lanes.h). xyz are three such arrays. x
/// and v must not overlap. Functions that take `points` leave the padding out. In those that take
/// `modes`, `points` is even, mode m at point i is modes[m * stride + i], a cloud's second half
/// mirrors the first (cloud.h), and `count` is mode_count(false) or mode_count(true) (modes.h).
template <class Real>
struct Kernels {
  /// Box round the first `points` points, its middle, and the largest distance of a point from
  /// there. False when a coordinate is not finite.
  bool (*bounds)(const Real* const xyz[3], int points, Real low[3], Real high[3], Real centre[3],
                 Real* radius);
  /// Where z < r:
  ///   v_z <- |v_z|
  ///   z   <- r
  void (*floor)(Real r, int stride, Real* z, Real* vz);
  /// Sets the bits of `words`, of which there are words_for(points) (point_set.h), where
  ///   (|x| + r)^2 + (|y| + r)^2 > arena_squared
  /// and clears the others. Returns whether any is set.
  bool (*wall)(const Real* x, const Real* y, int points, Real r, Real arena_squared,
               std::uint64_t* words);
  /// v <- v + gain
  /// x <- x + h v
  void (*predict)(Real h, Real gain, int points, Real* x, Real* v);
  /// sums[m] = sum over the points i of mode_m(i) (xyz(i) - xyz(0)),    m = 0 ... count - 1
  void (*fit)(const Real* modes, int count, int points, int stride, const Real* const xyz[3],
              Real sums[][3]);
  /// Pulls points towards their goals:
  ///   d(i) = sum over m of goal[m] mode_m(i) - (x(i) - x(0))
  ///   x <- x + position_share d
  ///   v <- v + velocity_share d
  void (*pull)(const Real* modes, int count, int points, int stride, const Real* goal,
               Real position_share, Real velocity_share, Real* x, Real* v);
  /// The same with damping:
  ///   d(i) = sum over m of goal[m] mode_m(i) - stiffness (x(i) - x(0)) - drag (v(i) - v(0))
  ///   x <- x + d
  ///   v <- v + rate d
  void (*pull_damped)(const Real* modes, int count, int points, int stride, const Real* goal,
                      Real stiffness, Real drag, Real rate, Real* x, Real* v);
  /// Puts the nearest rotations in place of 3 x 3 matrices: element i, j of matrix m is
  /// a[3 * j + i][m]. Returns for which matrices that could be done, one bit each: those with a
  /// positive determinant that are far from flat. The others are undefined.
  std::uint32_t (*rotations)(double a[9][kRotationLanes]);
  /// Sum of a[i] b[i] over all `stride` elements.
  Real (*dot)(const Real* a, const Real* b, int stride);
  /// Sets the bits of `words`, of which there are words_for(points) (point_set.h), where
  ///   cosine (y - cy) - sine (x - cx) > 0
  /// and clears the others.
  void (*left)(const Real* x, const Real* y, int points, Real cx, Real cy, Real cosine, Real sine,
               std::uint64_t* words);
  /// Copies the points inside the region to `out`, in order, with one pack of points far away
  /// behind them.
  void (*gather)(const Real* const xyz[3], int points, const Region<Real>& region,
                 Candidates<Real>& out);
  /// The box round some candidates, at least one.
  void (*box)(const Candidates<Real>& candidates, Real low[3], Real high[3]);
  /// Contacts between the candidates of two pups, at least one each: pairs nearer than `reach`. At
  /// equal heights `a` is the upper one. At equal distances the candidate of the lower index is the
  /// nearer one. Returns whether there is a contact. Without one the contents of `contacts_a` and
  /// `contacts_b` are undefined. touch_nearest finds the nearest lower point of each candidate,
  /// touch_sums the sums over all touching lower points.
  using FindTouching = bool(const Candidates<Real>& a, const Candidates<Real>& b, Real reach,
                            const CandidateContacts<Real>& contacts_a,
                            const CandidateContacts<Real>& contacts_b,
                            const TouchMemory<Real>& memory);
  FindTouching* touch_nearest;
  FindTouching* touch_sums;
};

/// The loops for one instruction set, which must be supported.
template <class Real>
const Kernels<Real>& kernels_for(InstructionSet set);

}  // namespace pupflow
