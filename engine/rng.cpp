#include "engine/rng.h"

#include <bit>
#include <cmath>

namespace pupflow {

std::uint64_t mix_bits(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15u;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

Rng::Rng(std::uint64_t seed, std::uint64_t stream) {
  std::uint64_t word = mix_bits(seed) ^ mix_bits(~stream);
  for (std::uint64_t& part : state_) part = word = mix_bits(word);
}

std::uint64_t Rng::next() {
  const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
  const std::uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Rng::uniform() {
  return static_cast<double>(next() >> 11) * 0x1p-53;
}

Eigen::Matrix3d Rng::rotation() {
  // Two points uniform in the unit disc give a quaternion uniform on the 3-sphere (Marsaglia 1972).
  double a, b, c, d, s, t;
  do {
    a = uniform(-1, 1);
    b = uniform(-1, 1);
    s = a * a + b * b;
  } while (s >= 1);
  do {
    c = uniform(-1, 1);
    d = uniform(-1, 1);
    t = c * c + d * d;
  } while (t >= 1 || t == 0);
  const double scale = std::sqrt((1 - s) / t);
  const double w = a, x = b, y = c * scale, z = d * scale;
  Eigen::Matrix3d rotation;
  rotation << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),          //
      2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y);
  return rotation;
}

}  // namespace pupflow
