// Tight kernels: what the loops over points of a stage take when nothing else is asked of them. The
// compiler may contract and reorder as it likes, so these show what the engine's promise of the
// same bits everywhere costs.
#pragma once

#include <string_view>
#include <vector>

namespace pupflow::bench {

/// The points of one pup, `count` of them in whole packs of 64 bytes.
template <class Real>
struct TightPup {
  Real* position[3];
  Real* velocity[3];
  int count;
};

template <class Real>
struct TightKernels {
  /// How many floats fill a register: as many points as the engine's contact search groups.
  int group;
  /// v <- v + gain, x <- x + h v.
  void (*predict)(const TightPup<Real>& pup, const Real gain[3], Real h);
  /// The sums of 9 modes times position (modes one after the other), a multiple of them as
  /// coefficients of the goals, and the pull towards those. No rotation, no volume factor.
  void (*match)(const TightPup<Real>& pup, const Real* modes, Real share, Real rate);
  /// The box, and the furthest distance from its middle, squared.
  Real (*bounds)(const TightPup<Real>& pup, Real low[3], Real high[3]);
  /// How many pairs of `a` and `b` (x, y, z; count_b in whole packs) are nearer than sqrt(limit).
  int (*near_pairs)(const Real* const a[3], int count_a, const Real* const b[3], int count_b,
                    Real limit);
};

/// Tight kernels as one compilation made them.
template <class Real>
struct TightVariant {
  std::string_view name;  // of the instruction set, and whether multiplications are fused with sums
  const TightKernels<Real>* kernels;
};

/// Those that this processor can run, the plainest first.
template <class Real>
std::vector<TightVariant<Real>> tight_variants();

}  // namespace pupflow::bench
