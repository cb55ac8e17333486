#include "engine/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/rng.h"

namespace pupflow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Distance of `value` from `expected` in units of the latter's last place.
double ulps(double value, double expected) {
  const double unit = std::abs(std::nextafter(expected, kInfinity) - expected);
  return std::abs(value - expected) / unit;
}

TEST(Elementary, ExpAgreesWithTheLibrary) {
  Rng random(1);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-708, 709);
    ASSERT_LE(ulps(exp_fixed(x), std::exp(x)), 3) << x;
  }
  EXPECT_EQ(exp_fixed(0), 1);
  EXPECT_EQ(exp_fixed(-kInfinity), 0);
  EXPECT_EQ(exp_fixed(kInfinity), kInfinity);
  EXPECT_EQ(exp_fixed(1e6), kInfinity);
  EXPECT_EQ(exp_fixed(-1e6), 0);
  EXPECT_NEAR(exp_fixed(-740), std::exp(-740), 1e-322);  // subnormal
  EXPECT_TRUE(std::isnan(exp_fixed(std::nan(""))));
}

TEST(Elementary, Expm1KeepsItsDigitsNearZero) {
  Rng random(2);
  for (int i = 0; i < 20000; ++i) {
    const double size = std::pow(10, random.uniform(-20, 1));
    for (const double x : {size, -size}) {
      ASSERT_LE(ulps(expm1_fixed(x), std::expm1(x)), 4) << x;
    }
  }
  EXPECT_EQ(expm1_fixed(0), 0);
  EXPECT_EQ(expm1_fixed(-kInfinity), -1);
}

TEST(Elementary, AtanAgreesWithTheLibrary) {
  Rng random(3);
  for (int i = 0; i < 20000; ++i) {
    const double x = std::pow(10, random.uniform(-8, 8)) * (i % 2 == 0 ? 1 : -1);
    ASSERT_LE(ulps(atan_fixed(x), std::atan(x)), 3) << x;
  }
  EXPECT_DOUBLE_EQ(atan_fixed(kInfinity), kPi / 2);
  EXPECT_DOUBLE_EQ(atan_fixed(-kInfinity), -kPi / 2);
  EXPECT_EQ(atan_fixed(0), 0);
}

TEST(Elementary, Atan2KnowsItsQuadrants) {
  for (int degrees = -179; degrees <= 180; ++degrees) {
    const double angle = degrees * kPi / 180;
    const double y = 3 * std::sin(angle), x = 3 * std::cos(angle);
    ASSERT_NEAR(atan2_fixed(y, x), std::atan2(y, x), 1e-15) << degrees;
  }
  EXPECT_EQ(atan2_fixed(0, 0), 0);
  EXPECT_DOUBLE_EQ(atan2_fixed(1, 0), kPi / 2);
  EXPECT_DOUBLE_EQ(atan2_fixed(0, -1), kPi);
}

TEST(Elementary, SineAndCosineAgreeWithTheLibrary) {
  Rng random(4);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-10, 10);
    const SinCos both = sincos_fixed(x);
    ASSERT_NEAR(both.sin, std::sin(x), 3e-16) << x;
    ASSERT_NEAR(both.cos, std::cos(x), 3e-16) << x;
  }
}

TEST(Elementary, WrapKeepsTheDirectionWithinHalfATurn) {
  for (const double x : {0.0, 3.0, -3.0, 4.0, -4.0, 100.0, -1000.0, kPi, -kPi}) {
    const double wrapped = wrap_angle(x);
    EXPECT_GT(wrapped, -kPi);
    EXPECT_LE(wrapped, kPi);
    EXPECT_NEAR(std::cos(wrapped), std::cos(x), 1e-13);
    EXPECT_NEAR(std::sin(wrapped), std::sin(x), 1e-13);
  }
}

TEST(Elementary, InverseCubeRoot) {
  Rng random(5);
  for (int i = 0; i < 20000; ++i) {
    const double x = std::pow(10, random.uniform(-30, 30));
    ASSERT_NEAR(inverse_cbrt_fixed(x) * std::cbrt(x), 1, 1e-15) << x;
  }
}

}  // namespace
}  // namespace pupflow
