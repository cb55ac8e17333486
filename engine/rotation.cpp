#include "engine/rotation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace pupflow {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Below this share of the largest possible determinant a cloud counts as flat.
constexpr double kFlat = 1e-6;
// Below this ratio to the largest, a singular value counts as zero.
constexpr double kRank = 1e-12;

/// Matrix of cofactors: det(a) times the inverse transposed.
Matrix3d cofactors(const Matrix3d& a) {
  Matrix3d c;
  for (int j = 0; j < 3; ++j) {
    const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    for (int i = 0; i < 3; ++i) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
      c(i, j) = a(i1, j1) * a(i2, j2) - a(i1, j2) * a(i2, j1);
    }
  }
  return c;
}

double dot_columns(const Matrix3d& a, int i, const Matrix3d& b, int j) {
  return a(0, i) * b(0, j) + a(1, i) * b(1, j) + a(2, i) * b(2, j);
}

double norm_squared(const Matrix3d& a) {
  return dot_columns(a, 0, a, 0) + dot_columns(a, 1, a, 1) + dot_columns(a, 2, a, 2);
}

/// Newton's iteration to the orthogonal polar factor of `a`, which has det > 0:
///
///   x <- (s x + x^(-T) / s) / 2
Matrix3d polar_by_newton(const Matrix3d& a) {
  Matrix3d x = a;
  double change = 1;
  for (int i = 0; i < 20 && change > 1e-30; ++i) {
    const Matrix3d c = cofactors(x);
    const double inverse_det = 1 / dot_columns(x, 0, c, 0);
    // Scaling brings singular values that are far from 1 near it. In the last iterations it would
    // only add rounding errors.
    const double scale =
        change > 1e-4
            ? std::sqrt(std::sqrt(norm_squared(c) / norm_squared(x)) * std::abs(inverse_det))
            : 1;
    const double keep = 0.5 * scale, turn = 0.5 * inverse_det / scale;
    change = 0;
    for (int k = 0; k < 9; ++k) {
      const double next = keep * x.data()[k] + turn * c.data()[k];
      const double difference = next - x.data()[k];
      change += difference * difference;
      x.data()[k] = next;
    }
  }
  return x;
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

}  // namespace

Rotation nearest_rotation(const Matrix3d& a) {
  double size = 0;
  for (int i = 0; i < 9; ++i) {
    if (!std::isfinite(a.data()[i])) return {Matrix3d::Identity(), RotationKind::arbitrary};
    size = std::max(size, std::abs(a.data()[i]));
  }
  if (size == 0) return {Matrix3d::Identity(), RotationKind::arbitrary};
  Matrix3d scaled;
  for (int i = 0; i < 9; ++i) scaled.data()[i] = a.data()[i] / size;
  const double det = dot_columns(scaled, 0, cofactors(scaled), 0);
  const double norm = norm_squared(scaled);
  if (det > kFlat * norm * std::sqrt(norm)) return {polar_by_newton(scaled), RotationKind::regular};
  return rotation_by_singular_values(scaled);
}

}  // namespace pupflow
