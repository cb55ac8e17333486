#include "engine/rotation.h"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <cmath>
#include <limits>

#include "engine/rng.h"

namespace pupflow {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d oracle(const Matrix3d& a) {
  const Eigen::JacobiSVD<Matrix3d> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

void expect_proper(const Matrix3d& r) {
  EXPECT_LT((r.transpose() * r - Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_NEAR(r.determinant(), 1, 1e-14);
}

Matrix3d with_singular_values(Rng& random, double s1, double s2, double s3) {
  return random.rotation() * Vector3d(s1, s2, s3).asDiagonal() * random.rotation().transpose();
}

TEST(Rotation, AgreesWithTheSingularValueDecomposition) {
  Rng random(1);
  for (int i = 0; i < 5000; ++i) {
    const Matrix3d a = with_singular_values(random, random.uniform(0.5, 2), random.uniform(0.5, 2),
                                            random.uniform(0.5, 2));
    const Rotation r = nearest_rotation(a);
    ASSERT_EQ(r.kind, RotationKind::regular);
    ASSERT_LT((r.matrix - oracle(a)).norm(), 1e-14);
    expect_proper(r.matrix);
  }
}

TEST(Rotation, SurvivesNearlyFlatClouds) {
  Rng random(2);
  for (double thin = 1e-1; thin > 1e-15; thin /= 10) {
    for (int i = 0; i < 50; ++i) {
      const Matrix3d a = with_singular_values(random, 1, 0.7, thin);
      const Rotation r = nearest_rotation(a);
      EXPECT_NE(r.kind, RotationKind::arbitrary);
      EXPECT_LT((r.matrix - oracle(a)).norm(), 2e-14) << thin;
      expect_proper(r.matrix);
    }
  }
}

TEST(Rotation, FlatAndMirroredCloudsHaveOneNearestRotation) {
  Rng random(3);
  for (int i = 0; i < 500; ++i) {
    for (const double third : {0.0, -0.01, -0.3}) {
      const Matrix3d a = with_singular_values(random, 1, 0.6, third);
      const Rotation r = nearest_rotation(a);
      ASSERT_EQ(r.kind, RotationKind::fallback);
      ASSERT_LT((r.matrix - oracle(a)).norm(), 1e-13);
      expect_proper(r.matrix);
    }
  }
}

TEST(Rotation, SaysWhenItIsArbitrary) {
  Rng random(4);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Matrix3d& a :
       {Matrix3d(Matrix3d::Zero()), with_singular_values(random, 1, 0, 0),
        with_singular_values(random, 1, 1e-14, 0), Matrix3d(Matrix3d::Constant(nan)),
        Matrix3d(Matrix3d::Constant(std::numeric_limits<double>::infinity()))}) {
    const Rotation r = nearest_rotation(a);
    EXPECT_EQ(r.kind, RotationKind::arbitrary);
    expect_proper(r.matrix);
  }
}

TEST(Rotation, MinimisesTheDistanceAlsoOnALine) {
  Rng random(5);
  const Matrix3d a = with_singular_values(random, 2, 0, 0);
  const double best = (nearest_rotation(a).matrix - a).norm();
  for (int i = 0; i < 2000; ++i) EXPECT_GE((random.rotation() - a).norm(), best - 1e-12);
}

TEST(Rotation, ScaleDoesNotMatter) {
  Rng random(6);
  const Matrix3d a = with_singular_values(random, 1, 0.8, 0.5);
  for (const double scale : {1e-300, 1e-30, 1e30, 1e300}) {
    EXPECT_LT((nearest_rotation(scale * a).matrix - nearest_rotation(a).matrix).norm(), 1e-14);
  }
}

TEST(Rotation, HalfTurnsAreNoTrap) {
  const Matrix3d half = Vector3d(-1, -1, 1).asDiagonal();
  EXPECT_LT((nearest_rotation(2 * half).matrix - half).norm(), 1e-15);
}

}  // namespace
}  // namespace pupflow
