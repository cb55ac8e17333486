// Elementary functions that give the same bits on every machine. The C library's differ between
// versions, and between processors with and without fused multiply-add; these use only + - * / and
// square roots, which IEEE 754 fixes. Accurate to about 2 units in the last place.
#pragma once

namespace pupflow {

constexpr double kPi = 3.14159265358979323846;

/// e^x; 0 and infinity beyond the range of double.
double exp_fixed(double x);

/// e^x - 1, accurate near 0 too.
double expm1_fixed(double x);

/// ln x for finite, normal x > 0.
double log_fixed(double x);

/// arctan x in (-pi/2, pi/2); infinite arguments give the limits.
double atan_fixed(double x);

/// Direction of (x, y) in (-pi, pi]; 0 for (0, 0).
double atan2_fixed(double y, double x);

struct SinCos {
  double sin, cos;
};

/// Sine and cosine of an angle in radians, |radians| <= 1000.
SinCos sincos_fixed(double radians);

/// The same direction as an angle in (-pi, pi]. `radians` must be finite.
double wrap_angle(double radians);

/// x^(-1/3) for finite, normal x > 0. Some number where x is infinite.
double inverse_cbrt_fixed(double x);

}  // namespace pupflow
