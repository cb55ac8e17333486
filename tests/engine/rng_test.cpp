#include "engine/rng.h"

#include <gtest/gtest.h>
#include <Eigen/LU>

namespace pupflow {
namespace {

TEST(Rng, FirstNumbersNeverChange) {
  // Written down once: a changed generator would silently give every seed another litter.
  Rng random(1);
  EXPECT_EQ(random.next(), 0x9591aa112819439bu);
}

TEST(Rng, StreamsAndSeedsDiffer) {
  EXPECT_NE(Rng(1, 0).next(), Rng(1, 1).next());
  EXPECT_NE(Rng(1, 0).next(), Rng(2, 0).next());
  EXPECT_NE(Rng(0, 1).next(), Rng(1, 0).next());
}

TEST(Rng, UniformHasTheRightMoments) {
  Rng random(7);
  double sum = 0, square = 0;
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
    square += u * u;
  }
  EXPECT_NEAR(sum / n, 0.5, 5 * 0.2887 / std::sqrt(n));
  EXPECT_NEAR(square / n, 1.0 / 3, 5 * 0.3 / std::sqrt(n));
}

TEST(Rng, RotationsAreProperAndUniform) {
  Rng random(8);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  double trace_squares = 0;
  const int n = 50000;
  for (int i = 0; i < n; ++i) {
    const Eigen::Matrix3d r = random.rotation();
    ASSERT_LT((r * r.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    ASSERT_NEAR(r.determinant(), 1, 1e-14);
    sum += r;
    trace_squares += r.trace() * r.trace();
  }
  // Under the uniform measure every entry has mean 0 and variance 1/3, and the trace mean square 1.
  EXPECT_LT((sum / n).cwiseAbs().maxCoeff(), 5 * 0.58 / std::sqrt(n));
  EXPECT_NEAR(trace_squares / n, 1, 0.05);
}

}  // namespace
}  // namespace pupflow
