#include "engine/rotation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "engine/kernels.h"

namespace pupflow {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Below this ratio to the largest, a singular value counts as zero.
constexpr double kRank = 1e-12;

double dot_columns(const Matrix3d& a, int i, const Matrix3d& b, int j) {
  return a(0, i) * b(0, j) + a(1, i) * b(1, j) + a(2, i) * b(2, j);
}

/// Turns columns p and q of `u` to right angles, and those of `v` along. Returns whether it had to.
bool jacobi_turn(Matrix3d& u, Matrix3d& v, int p, int q) {
  const double alpha = dot_columns(u, p, u, p), beta = dot_columns(u, q, u, q);
  const double gamma = dot_columns(u, p, u, q);
  if (std::abs(gamma) <= 1e-16 * std::sqrt(alpha * beta)) return false;
  const double zeta = (beta - alpha) / (2 * gamma);
  const double t = std::copysign(1 / (std::abs(zeta) + std::sqrt(1 + zeta * zeta)), zeta);
  const double c = 1 / std::sqrt(1 + t * t), s = c * t;
  for (Matrix3d* m : {&u, &v}) {
    for (int i = 0; i < 3; ++i) {
      const double a = (*m)(i, p), b = (*m)(i, q);
      (*m)(i, p) = c * a - s * b;
      (*m)(i, q) = s * a + c * b;
    }
  }
  return true;
}

/// A unit vector at right angles to the unit vector `u`.
Vector3d any_perpendicular(const Vector3d& u) {
  int least = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(u[i]) < std::abs(u[least])) least = i;
  }
  return u.cross(Vector3d::Unit(least)).normalized();
}

Rotation rotation_by_singular_values(const Matrix3d& a) {
  Matrix3d u = a, v = Matrix3d::Identity();  // u stays a v, its columns become sigma_i u_i
  for (int sweep = 0; sweep < 30; ++sweep) {
    bool turned = jacobi_turn(u, v, 0, 1);
    turned |= jacobi_turn(u, v, 0, 2);
    turned |= jacobi_turn(u, v, 1, 2);
    if (!turned) break;
  }
  std::array<int, 3> order{0, 1, 2};
  std::array<double, 3> sigma{};
  for (int i = 0; i < 3; ++i) sigma[i] = std::sqrt(dot_columns(u, i, u, i));
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return sigma[i] > sigma[j]; });
  const double first = sigma[order[0]], second = sigma[order[1]];
  const Vector3d u0 = u.col(order[0]) / first;
  const bool line = second <= kRank * first;
  Vector3d u1 = line ? any_perpendicular(u0) : Vector3d(u.col(order[1]) / second);
  u1 = (u1 - u0 * u0.dot(u1)).normalized();
  // The third axes are cross products on both sides. So det = +1, and where det(a) < 0 the smallest
  // singular value changes its sign.
  const Vector3d v0 = v.col(order[0]), v1 = v.col(order[1]);
  const Matrix3d r =
      u0 * v0.transpose() + u1 * v1.transpose() + u0.cross(u1) * v0.cross(v1).transpose();
  return {r, line ? RotationKind::arbitrary : RotationKind::fallback};
}

/// The rotation of a matrix that is no regular one.
Rotation irregular_rotation(const Matrix3d& a) {
  double size = 0;
  for (int i = 0; i < 9; ++i) {
    if (!std::isfinite(a.data()[i])) return {Matrix3d::Identity(), RotationKind::arbitrary};
    size = std::max(size, std::abs(a.data()[i]));
  }
  if (size == 0) return {Matrix3d::Identity(), RotationKind::arbitrary};
  Matrix3d scaled;
  for (int i = 0; i < 9; ++i) scaled.data()[i] = a.data()[i] / size;
  return rotation_by_singular_values(scaled);
}

}  // namespace

Rotation nearest_rotation(const Matrix3d& a) {
  Rotation rotation;
  nearest_rotations({&a, 1}, &rotation);
  return rotation;
}

void nearest_rotations(std::span<const Matrix3d> a, Rotation* out) {
  static const Kernels<double>& kernels = kernels_for<double>(supported_instruction_sets().back());
  for (std::size_t first = 0; first < a.size(); first += kRotationLanes) {
    const std::size_t count = std::min<std::size_t>(kRotationLanes, a.size() - first);
    double lanes[9][kRotationLanes];
    for (std::size_t m = 0; m < kRotationLanes; ++m) {  // lanes without a matrix repeat the last
      const Matrix3d& matrix = a[first + std::min(m, count - 1)];
      for (int k = 0; k < 9; ++k) lanes[k][m] = matrix.data()[k];
    }
    const std::uint32_t regular = kernels.rotations(lanes);
    for (std::size_t m = 0; m < count; ++m) {
      if (((regular >> m) & 1) == 0) {
        out[first + m] = irregular_rotation(a[first + m]);
        continue;
      }
      for (int k = 0; k < 9; ++k) out[first + m].matrix.data()[k] = lanes[k][m];
      out[first + m].kind = RotationKind::regular;
    }
  }
}

}  // namespace pupflow
