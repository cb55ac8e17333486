#include "engine/cloud.h"

#include <array>
#include <cassert>
#include <cmath>

#include "engine/lanes.h"

namespace pupflow {
namespace {

/// The mean and the eight deformation modes at one rest offset, not yet scaled.
std::array<double, kModes> modes_at(const Eigen::Vector3d& q) {
  const double x = q.x(), y = q.y(), z = q.z();
  return {1, x, y, z, x * x - y * y, 2 * z * z - x * x - y * y, x * y, y * z, z * x};
}

/// Whether the second half of `rest` is the first half through the centre.
[[maybe_unused]] bool is_mirrored(const std::vector<Eigen::Vector3d>& rest) {
  const std::size_t half = rest.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    if (rest[half + i] != -rest[i]) return false;
  }
  return rest.size() == 2 * half;
}

}  // namespace

template <class Real>
Cloud<Real> make_cloud(const std::vector<Eigen::Vector3d>& rest) {
  assert(!rest.empty() && is_mirrored(rest));
  Cloud<Real> cloud;
  cloud.points = static_cast<int>(rest.size());
  cloud.stride = stride_for<Real>(cloud.points);
  cloud.mode.assign(static_cast<std::size_t>(kModes) * cloud.stride, Real(0));
  std::array<double, kModes> square_sum{};
  for (const Eigen::Vector3d& q : rest) {
    const auto value = modes_at(q);
    for (int m = 0; m < kModes; ++m) square_sum[m] += value[m] * value[m];
  }
  cloud.linear_scale = std::sqrt(square_sum[1]);
  for (int i = 0; i < cloud.points; ++i) {
    const auto value = modes_at(rest[i]);
    for (int m = 0; m < kModes; ++m) {
      const double scale = m == kMeanMode ? square_sum[m] : std::sqrt(square_sum[m]);
      cloud.mode[static_cast<std::size_t>(m) * cloud.stride + i] =
          static_cast<Real>(value[m] / scale);
    }
  }
  return cloud;
}

template Cloud<float> make_cloud<float>(const std::vector<Eigen::Vector3d>&);
template Cloud<double> make_cloud<double>(const std::vector<Eigen::Vector3d>&);

}  // namespace pupflow
