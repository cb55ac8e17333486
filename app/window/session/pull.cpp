#include "app/window/session/pull.h"

#include <algorithm>
#include <cmath>

namespace pupflow::window {
namespace {

constexpr double kHeldFor = 0.03;  // s
constexpr double kFastest = 13;    // 1/s
constexpr double kLongestWay = 4;  // pup radii

/// The nearest number of five digits, which is short in a file.
double rounded(double x) {
  if (!std::isfinite(x)) return x;
  if (std::abs(x) < 1e-100) return 0;
  const double exponent = 4 - std::floor(std::log10(std::abs(x)));
  const double scale = std::pow(10.0, std::abs(exponent));
  return exponent < 0 ? std::round(x / scale) * scale : std::round(x * scale) / scale;
}

}  // namespace

std::int64_t pull_steps(double dt) {
  return std::max<std::int64_t>(1, std::llround(std::min(kHeldFor / dt, 1e6)));
}

std::array<double, 3> pull_force(const LitterView& litter, int pup,
                                 const std::array<double, 3>& target) {
  const double held_for = static_cast<double>(pull_steps(litter.params.dt)) * litter.params.dt;
  const double w = std::min(kFastest, 0.5 / held_for);
  Eigen::Vector3d way =
      Eigen::Vector3d(target[0], target[1], target[2]) - litter.positions.mean(pup);
  const double longest = kLongestWay * litter.params.pup_radius;
  if (way.norm() > longest) way *= longest / way.norm();
  Eigen::Vector3d force = w * (w * way - 2 * litter.velocities.mean(pup));
  force.z() += litter.params.gravity;
  return {rounded(force.x()), rounded(force.y()), rounded(force.z())};
}

}  // namespace pupflow::window
