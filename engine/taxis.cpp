#include "engine/taxis.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/elementary.h"
#include "engine/point_set.h"

namespace pupflow {
namespace {

/// Mean of one component over a pup's points.
template <class Real>
Real mean_of(const Cloud<Real>& cloud, const State<Real>& state, const Real* component) {
  return state.kernels->dot(cloud.mode_row(kMeanMode), component, cloud.stride);
}

/// The exponent sigma t (t_p - t_b), finite whatever overflows on the way.
double excitation(const Params& params, double tb, double t) {
  constexpr double kLimit = std::numeric_limits<double>::max() / 4;
  const double need = params.tp - tb;
  if (need == 0 || t == 0 || params.sigma == 0) return 0;
  return std::clamp(params.sigma * t * need, -kLimit, kLimit);
}

/// Side temperatures about `direction`. With `first_on_axis` the first point is not on the left.
template <class Real>
SideTemperatures measure_sides(const Params& params, const Cloud<Real>& cloud,
                               const State<Real>& state, int pup, double direction,
                               bool first_on_axis) {
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
  double sum[2] = {0, 0};  // of T_c - T_a over the touching points: right, left
  for_each_point(touching, words,
                 [&](int i) { sum[is_left(i)] += state.tb[touched[i]] - params.ta; });
  int on_left = 0;
  for (int w = 0; w < words; ++w) on_left += std::popcount(left[w]);
  const int on_right = state.points - on_left;
  // Points that touch nobody feel T_a, and so does a side without points.
  return {params.ta + (on_left > 0 ? sum[1] / on_left : 0),
          params.ta + (on_right > 0 ? sum[0] / on_right : 0)};
}

}  // namespace

double turn(const Params& params, double tb, double t_left, double t_right) {
  const double left = excitation(params, tb, t_left), right = excitation(params, tb, t_right);
  // (S_L - S_R)/(S_L + S_R) with both sides multiplied by the denominators and exp(-top): the
  // largest exponential is then 1, so nothing overflows and the quotient is never 0/0.
  const double top = std::max({0.0, -left, -right});
  const double el = exp_fixed(-left - top), er = exp_fixed(-right - top);
  return atan_fixed(params.v * ((er - el) / (2 * exp_fixed(-top) + el + er)));
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
Status steer(const Params& params, const Cloud<Real>& cloud, State<Real>& state, int pup) {
  const bool course = params.heading == Heading::course;
  const bool touches = state.exposed[pup] < 1;  // else both sides feel T_a and there is no turn
  if (course && !touches) return {};
  const double direction = course ? state.heading[pup] : body_axis(cloud, state, pup);
  double delta = 0;
  if (touches) {
    const SideTemperatures t = course ? side_temperatures(params, cloud, state, pup, direction)
                                      : body_side_temperatures(params, cloud, state, pup);
    delta = turn(params, state.tb[pup], t.left, t.right);
  }
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
  template Status steer<Real>(const Params&, const Cloud<Real>&, State<Real>&, int);
PUPFLOW_INSTANTIATE(float)
PUPFLOW_INSTANTIATE(double)
#undef PUPFLOW_INSTANTIATE

}  // namespace pupflow
