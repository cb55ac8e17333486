#include "engine/taxis.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/elementary.h"
#include "engine/pack.h"

namespace pupflow {
namespace {

/// Mean of one component over a pup's points.
template <class Real>
Real mean_of(const Cloud<Real>& cloud, const Real* component) {
  using P = Pack<Real>;
  const Real* weight = cloud.mode_row(kMeanMode);
  P sum = P::zero();
  for (int i = 0; i < cloud.stride; i += kLanes<Real>) {
    sum += P::load(weight + i) * P::load(component + i);
  }
  return sum.sum();
}

/// The exponent sigma t (t_p - t_b), finite whatever overflows on the way.
double excitation(const Params& params, double tb, double t) {
  constexpr double kLimit = std::numeric_limits<double>::max() / 4;
  const double need = params.tp - tb;
  if (need == 0 || t == 0 || params.sigma == 0) return 0;
  return std::clamp(params.sigma * t * need, -kLimit, kLimit);
}

/// Temperatures felt on one side: those of nobody touched count as T_a.
struct Side {
  double sum = 0;  // of T_c - T_a over the touching points
  int points = 0;
  double mean(double ta) const { return points > 0 ? ta + sum / points : ta; }
};

/// Side temperatures about `direction`. `may_be_left` masks the points of the first pack.
template <class Real>
SideTemperatures measure_sides(const Params& params, const Cloud<Real>& cloud,
                               const State<Real>& state, int pup, double direction,
                               std::uint32_t may_be_left) {
  using P = Pack<Real>;
  const Real* x = state.x.data() + state.row(pup);
  const Real* y = state.y.data() + state.row(pup);
  const int* touched = state.touched.data() + state.flat(pup);
  const P cx = P::broadcast(mean_of(cloud, x)), cy = P::broadcast(mean_of(cloud, y));
  const SinCos axis = sincos_fixed(direction);
  const P cosine = P::broadcast(static_cast<Real>(axis.cos));
  const P sine = P::broadcast(static_cast<Real>(axis.sin));
  Side left, right;
  for (int block = 0; block < state.points; block += kLanes<Real>) {
    const P across = cosine * (P::load(y + block) - cy) - sine * (P::load(x + block) - cx);
    const int count = std::min(kLanes<Real>, state.points - block);
    std::uint32_t is_left = less_bits(P::zero(), across) & ((1u << count) - 1);
    if (block == 0) is_left &= may_be_left;
    left.points += std::popcount(is_left);
    for (int i = 0; i < count; ++i) {
      const int other = touched[block + i];
      if (other < 0) continue;
      Side& side = (is_left >> i & 1) != 0 ? left : right;
      side.sum += state.tb[other] - params.ta;
    }
  }
  right.points = state.points - left.points;
  return {left.mean(params.ta), right.mean(params.ta)};
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
  return atan2_fixed(static_cast<double>(mean_of(cloud, y) - y[0]),
                     static_cast<double>(mean_of(cloud, x) - x[0]));
}

template <class Real>
SideTemperatures side_temperatures(const Params& params, const Cloud<Real>& cloud,
                                   const State<Real>& state, int pup, double direction) {
  return measure_sides(params, cloud, state, pup, direction, ~0u);
}

template <class Real>
SideTemperatures body_side_temperatures(const Params& params, const Cloud<Real>& cloud,
                                        const State<Real>& state, int pup) {
  return measure_sides(params, cloud, state, pup, body_axis(cloud, state, pup), ~1u);
}

template <class Real>
Status steer(const Params& params, const Cloud<Real>& cloud, State<Real>& state) {
  for (int pup = 0; pup < state.pups; ++pup) {
    const bool course = params.heading == Heading::course;
    const bool touches = state.exposed[pup] < 1;  // else both sides feel T_a and there is no turn
    if (course && !touches) continue;
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
  }
  return {};
}

#define PUPFLOW_INSTANTIATE(Real)                                                           \
  template double body_axis<Real>(const Cloud<Real>&, const State<Real>&, int);             \
  template SideTemperatures side_temperatures<Real>(const Params&, const Cloud<Real>&,      \
                                                    const State<Real>&, int, double);       \
  template SideTemperatures body_side_temperatures<Real>(const Params&, const Cloud<Real>&, \
                                                         const State<Real>&, int);          \
  template Status steer<Real>(const Params&, const Cloud<Real>&, State<Real>&);
PUPFLOW_INSTANTIATE(float)
PUPFLOW_INSTANTIATE(double)
#undef PUPFLOW_INSTANTIATE

}  // namespace pupflow
