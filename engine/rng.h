// Random numbers with the same bits everywhere, which the standard library's distributions have
// not.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cassert>
#include <cstdint>

namespace pupflow {

/// One round of the SplitMix64 mixer (Steele, Lea & Flood 2014): a bijection that scatters bits.
std::uint64_t mix_bits(std::uint64_t value);

/// xoshiro256++ (Blackman & Vigna 2021), seeded through SplitMix64. `stream` selects one of many
/// independent sequences of the same seed, e.g. one per pup.
class Rng {
 public:
  explicit Rng(std::uint64_t seed, std::uint64_t stream = 0);

  std::uint64_t next();

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform();

  /// Uniform in [low, high).
  double uniform(double low, double high) {
    assert(low <= high);
    return low + (high - low) * uniform();
  }

  /// Uniform in SO(3): the rotation of a quaternion uniform on the 3-sphere (Marsaglia 1972).
  Eigen::Matrix3d rotation();

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace pupflow
