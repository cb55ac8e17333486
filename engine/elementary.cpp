#include "engine/elementary.h"

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pupflow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// pi/2 and ln 2 in pieces whose first has trailing zeros, so that small multiples of it are exact.
constexpr double kHalfPiHigh = 1.57079632673412561417e+00;
constexpr double kHalfPiLow = 6.07710050650619224932e-11;
constexpr double kLn2High = 6.93147180369123816490e-01;
constexpr double kLn2Low = 1.90821492927058770002e-10;

/// Value of c[0] + c[1] t + c[2] t^2 + ...
template <std::size_t N>
constexpr double horner(const std::array<double, N>& c, double t) {
  double value = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) value = value * t + c[i];
  return value;
}

/// Coefficients 1/(i+1)!, of (e^t - 1) / t.
constexpr std::array<double, 14> expm1_series() {
  std::array<double, 14> c{};
  double factorial = 1;
  for (std::size_t i = 0; i < c.size(); ++i) {
    factorial *= static_cast<double>(i + 1);
    c[i] = 1 / factorial;
  }
  return c;
}

/// Coefficients (-1)^i / (2i + first)!, of sine (first = 1, after a factor t) and cosine (first =
/// 0).
constexpr std::array<double, 10> circular_series(int first) {
  std::array<double, 10> c{};
  double factorial = 1;
  int n = first;
  for (std::size_t i = 0; i < c.size(); ++i) {
    c[i] = (i % 2 == 0 ? 1 : -1) / factorial;
    factorial *= (n + 1.0) * (n + 2.0);
    n += 2;
  }
  return c;
}

/// Coefficients (-1)^i / (2i + 1), of arctan t / t.
constexpr std::array<double, 22> atan_series() {
  std::array<double, 22> c{};
  for (std::size_t i = 0; i < c.size(); ++i) {
    c[i] = (i % 2 == 0 ? 1.0 : -1.0) / (2.0 * static_cast<double>(i) + 1.0);
  }
  return c;
}

/// Coefficients 1 / (2i + 1), of artanh t / t.
constexpr std::array<double, 12> atanh_series() {
  std::array<double, 12> c{};
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = 1 / (2.0 * static_cast<double>(i) + 1.0);
  return c;
}

constexpr auto kExpm1 = expm1_series();
constexpr auto kSin = circular_series(1);
constexpr auto kCos = circular_series(0);
constexpr auto kAtan = atan_series();
constexpr auto kAtanh = atanh_series();

/// 2^n for -1022 <= n <= 1023.
double power_of_two(int n) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52);
}

}  // namespace

double exp_fixed(double x) {
  if (std::isnan(x)) return x;
  if (x > 709.782712893384) return kInfinity;
  if (x < -745.2) return 0;
  const double n = std::nearbyint(x * 1.44269504088896340736);
  const double t = (x - n * kLn2High) - n * kLn2Low;
  const double value = 1 + t * horner(kExpm1, t);
  const int half =
      static_cast<int>(n) / 2;  // in two factors: n alone can leave the range of double
  return value * power_of_two(half) * power_of_two(static_cast<int>(n) - half);
}

double expm1_fixed(double x) {
  if (std::abs(x) < 0.5) return x * horner(kExpm1, x);
  return exp_fixed(x) - 1;
}

double log_fixed(double x) {
  assert(std::isnormal(x) && x > 0);
  // With x = m 2^n, 1/sqrt(2) <= m < sqrt(2):
  //
  //   ln x = n ln 2 + ln m
  //   ln m = 2 artanh(t),    t = (m - 1) / (m + 1)
  constexpr std::uint64_t kOneOverRoot2 = 0x3fe6a09e667f3bcd;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const auto n = static_cast<std::int64_t>(bits - kOneOverRoot2) >> 52;
  const double m = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(n) << 52));
  const double t = (m - 1) / (m + 1), power = static_cast<double>(n);
  return power * kLn2High + (2 * t * horner(kAtanh, t * t) + power * kLn2Low);
}

double atan_fixed(double x) {
  const double size = std::abs(x);
  double value = 0;
  if (size > 2.414213562373095) {  // tan(3 pi/8)
    const double t = -1 / size;
    value = kPi / 2 + t * horner(kAtan, t * t);
  } else if (size > 0.4142135623730950) {  // tan(pi/8)
    const double t = (size - 1) / (size + 1);
    value = kPi / 4 + t * horner(kAtan, t * t);
  } else {
    value = size * horner(kAtan, size * size);
  }
  return std::copysign(value, x);
}

double atan2_fixed(double y, double x) {
  if (x == 0 && y == 0) return 0;
  const double angle =
      std::isinf(x) && std::isinf(y) ? kPi / 4 : atan_fixed(std::abs(y) / std::abs(x));
  return std::copysign(x < 0 ? kPi - angle : angle, y);
}

SinCos sincos_fixed(double radians) {
  assert(std::abs(radians) <= 1000);
  const double n = std::nearbyint(radians * (2 / kPi));
  const double t = (radians - n * kHalfPiHigh) - n * kHalfPiLow;
  const double s = t * horner(kSin, t * t);
  const double c = horner(kCos, t * t);
  switch (static_cast<int>(n) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double wrap_angle(double radians) {
  assert(std::isfinite(radians));
  if (std::abs(radians) <= kPi && radians != -kPi) return radians;
  const double wrapped = std::remainder(radians, 2 * kPi);  // exact, by IEEE 754
  return wrapped <= -kPi ? kPi : wrapped;
}

double inverse_cbrt_fixed(double x) {
  assert(x >= std::numeric_limits<double>::min());
  // The first guess has the right exponent: -1/3 of that of x, taken from the bits. Newton's method
  // on 1/y^3 - x = 0 is then
  //
  //   y <- y + y (1 - x y^3) / 3
  double y = std::bit_cast<double>(0x553ef0ff289dd796u - std::bit_cast<std::uint64_t>(x) / 3);
  for (int i = 0; i < 4; ++i) y += y * (1 - x * y * y * y) * (1.0 / 3);
  return y;
}

}  // namespace pupflow
