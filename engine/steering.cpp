#include "engine/steering.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "engine/elementary.h"
#include "engine/point_set.h"

namespace pupflow {
namespace {

/// Mean of one component over a pup's points.
template <class Real>
Real mean_of(const Cloud<Real>& cloud, const State<Real>& state, const Real* component) {
  return state.kernels->dot(cloud.mode_row(kMeanMode), component, cloud.stride);
}

/// a b c, which overflows or vanishes only where the product itself does.
double product(double a, double b, double c) {
  const double first = a * b, plain = first * c;
  if (std::isnormal(first) && std::isfinite(plain)) return plain;
  int exponent[3] = {};
  const double mantissa =
      std::frexp(a, &exponent[0]) * std::frexp(b, &exponent[1]) * std::frexp(c, &exponent[2]);
  return std::ldexp(mantissa, exponent[0] + exponent[1] + exponent[2]);
}

/// The exponent sigma t (t_p - t_b). Infinite where it leaves the range of double, never NaN.
double excitation(const Params& params, double tb, double t) {
  const double need = params.preferred_temperature - tb;
  if (need == 0 || t == 0 || params.sensitivity == 0) return 0;
  if (std::isfinite(need)) return product(params.sensitivity, t, need);
  return 2 * product(params.sensitivity, t, params.preferred_temperature / 2 - tb / 2);
}

/// (S_L - S_R)/(S_L + S_R).
double preference(const Params& params, double tb, double t_left, double t_right) {
  // Larger exponents may be off by 1 and more, or have overflowed.
  constexpr double kCoarse = 0x1p53;
  const double left = excitation(params, tb, t_left), right = excitation(params, tb, t_right);
  // Both sides multiplied by the denominators and exp(-top): the largest exponential is then 1, so
  // nothing overflows and the quotient is never 0/0.
  const double top = std::max({0.0, -left, -right});
  if (top > kCoarse) {
    // The other terms are nothing beside the largest exponential, and the quotient is that of the
    // difference of the exponents.
    const double ahead = excitation(params, tb, t_left - t_right), size = std::abs(ahead);
    return std::copysign(-expm1_fixed(-size) / (1 + exp_fixed(-size)), ahead);
  }
  const double el = exp_fixed(-left - top), er = exp_fixed(-right - top);
  return (er - el) / (2 * exp_fixed(-top) + el + er);
}

/// Side temperatures about `direction`. With `first_on_axis` the first point is not on the left.
/// Writes for each point whether it is on the left, unless `on_the_left` is null.
template <class Real>
SideTemperatures measure_sides(const Params& params, const Cloud<Real>& cloud,
                               const State<Real>& state, int pup, double direction,
                               bool first_on_axis, std::uint8_t* on_the_left = nullptr) {
  assert(cloud.points == state.points && cloud.stride == state.stride);
  const Real* x = state.x.data() + state.row(pup);
  const Real* y = state.y.data() + state.row(pup);
  const int* touched = state.touched.data() + state.flat(pup);
  const SinCos axis = sincos_fixed(direction);
  const int words = words_for(state.points);
  const std::uint64_t* touching = state.touching_points.data() + state.set(pup);
  std::uint64_t left[kMaxPointWords];
  state.kernels->left(x, y, state.points, mean_of(cloud, state, x), mean_of(cloud, state, y),
                      static_cast<Real>(axis.cos), static_cast<Real>(axis.sin), left);
  if (first_on_axis) left[0] &= ~std::uint64_t{1};
  const auto is_left = [&](int i) { return (left[i / 64] >> (i % 64)) & 1; };
  if (on_the_left != nullptr) {
    for (int i = 0; i < state.points; ++i) on_the_left[i] = is_left(i) ? 1 : 0;
  }
  int on_left = 0;
  for (int w = 0; w < words; ++w) on_left += std::popcount(left[w]);
  const int on_right = state.points - on_left;
  // Points without contact feel T_a, and so does a side without points.
  const auto means = [&](double unit) -> SideTemperatures {
    double sum_left = 0, sum_right = 0;  // sums of T_c - T_a over the touching points
    for_each_point(touching, words, [&](int i) {
      assert(i < state.points && touched[i] >= 0 && touched[i] < state.pups && touched[i] != pup);
      const double warmth = unit * state.tb[touched[i]] - unit * params.ambient_temperature;
      // Nobody can predict the side, so there is no branch. A sum is never -0: adding 0 leaves it.
      sum_left += is_left(i) ? warmth : 0;
      sum_right += is_left(i) ? 0 : warmth;
    });
    return {(unit * params.ambient_temperature + (on_left > 0 ? sum_left / on_left : 0)) / unit,
            (unit * params.ambient_temperature + (on_right > 0 ? sum_right / on_right : 0)) / unit};
  };
  const SideTemperatures plain = means(1);
  return std::isfinite(plain.left) && std::isfinite(plain.right) ? plain : means(kSumUnit);
}

}  // namespace

double turn(const Params& params, double tb, double t_left, double t_right) {
  return atan_fixed(params.steering_gain * preference(params, tb, t_left, t_right));
}

template <class Real>
double body_axis(const Cloud<Real>& cloud, const State<Real>& state, int pup) {
  const std::size_t row = state.row(pup);
  const Real* x = state.x.data() + row;
  const Real* y = state.y.data() + row;
  return atan2_fixed(static_cast<double>(mean_of(cloud, state, y) - y[0]),
                     static_cast<double>(mean_of(cloud, state, x) - x[0]));
}

template <class Real>
SideTemperatures side_temperatures(const Params& params, const Cloud<Real>& cloud,
                                   const State<Real>& state, int pup, double direction) {
  return measure_sides(params, cloud, state, pup, direction, false);
}

template <class Real>
SideTemperatures body_side_temperatures(const Params& params, const Cloud<Real>& cloud,
                                        const State<Real>& state, int pup) {
  return measure_sides(params, cloud, state, pup, body_axis(cloud, state, pup), true);
}

template <class Real>
Status steer(const Params& params, SteeringParts parts, const Cloud<Real>& cloud,
             State<Real>& state, int pup) {
  const bool course = params.heading == Heading::course;
  // A pup without contacts feels T_a on both sides and does not turn.
  const bool turns = parts.turn && state.exposed[pup] < 1;
  const std::optional<double> imposed = state.action(pup).turn;
  if (course && !turns && !imposed && !parts.sides) return {};
  const double direction = course ? state.heading[pup] : body_axis(cloud, state, pup);
  if (!std::isfinite(direction))
    return {Status::Kind::non_finite, Stage::steering, state.step + 1, pup, -1};
  double delta = 0;
  if (turns || parts.sides) {
    std::uint8_t* const left = parts.sides ? state.left.data() + state.flat(pup) : nullptr;
    const SideTemperatures t = measure_sides(params, cloud, state, pup, direction, !course, left);
    const double felt = 0.0 + turn(params, state.tb[pup], t.left, t.right);  // -0 is no turn
    if (turns) delta = felt;
    if (parts.sides) {
      state.t_left[pup] = t.left;
      state.t_right[pup] = t.right;
      state.turn[pup] = imposed.value_or(felt);
    }
  }
  if (imposed) delta = *imposed;
  if (!parts.direction) return {};
  const double next = direction + (course ? params.dt * delta : delta);
  if (!std::isfinite(next))
    return {Status::Kind::non_finite, Stage::steering, state.step + 1, pup, -1};
  state.heading[pup] = wrap_angle(next);
  return {};
}

#define PUPFLOW_INSTANTIATE(Real)                                                           \
  template double body_axis<Real>(const Cloud<Real>&, const State<Real>&, int);             \
  template SideTemperatures side_temperatures<Real>(const Params&, const Cloud<Real>&,      \
                                                    const State<Real>&, int, double);       \
  template SideTemperatures body_side_temperatures<Real>(const Params&, const Cloud<Real>&, \
                                                         const State<Real>&, int);          \
  template Status steer<Real>(const Params&, SteeringParts, const Cloud<Real>&, State<Real>&, int);
PUPFLOW_INSTANTIATE(float)
PUPFLOW_INSTANTIATE(double)
#undef PUPFLOW_INSTANTIATE

}  // namespace pupflow
