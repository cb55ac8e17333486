#include "engine/heat.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/elementary.h"
#include "engine/point_set.h"

namespace pupflow {
namespace {

/// Mean temperature of the pups that the points of `pup` touch; 0 without contact.
template <class Real>
double mean_touched_temperature(const State<Real>& state, int pup) {
  const int* touched = state.touched.data() + state.flat(pup);
  const std::uint64_t* touching = state.touching_points.data() + state.set(pup);
  const auto mean = [&](double unit) {
    double sum = 0;
    int count = 0;
    for_each_point(touching, words_for(state.points), [&](int i) {
      assert(i < state.points && touched[i] >= 0 && touched[i] < state.pups && touched[i] != pup);
      sum += unit * state.tb[touched[i]];
      ++count;
    });
    return count > 0 ? sum / count / unit : 0;
  };
  const double plain = mean(1);
  return std::isfinite(plain) ? plain : mean(kSumUnit);
}

/// T_b after one step as a weighted mean of T_b, T_a and T_c plus the part of G:
///
///   k        = k1 A + k2 (1 - A)
///   T_b(t+h) = e^(-k h) T_b + (1 - e^(-k h)) (k1 A T_a + k2 (1 - A) T_c + G) / k
///
/// With heat = euler, 1 - k h is in place of e^(-k h). For rates that overflow, and for a T_b that
/// decays by more than a factor of e: the rounding error of a large T_b can then be larger than the
/// result.
double mean_after_step(const Params& params, double tb, double produced, double to_air,
                       double to_others, double contact_mean) {
  const double conductance = to_air + to_others, decay = conductance * params.dt;
  const bool exact = params.heat == HeatRule::exact;
  const double gone = exact ? -expm1_fixed(-decay) : decay;  // share of T_b that is replaced
  const double kept = exact ? exp_fixed(-decay) : 1 - decay;
  // The time over which G adds up.
  const double duration = exact && decay > 0 ? gone / conductance : params.dt;
  double sum = duration * (kSumUnit * produced) + kept * (kSumUnit * tb);
  if (to_air > 0) sum += to_air / conductance * gone * (kSumUnit * params.ambient_temperature);
  if (to_others > 0) sum += to_others / conductance * gone * (kSumUnit * contact_mean);
  return sum / kSumUnit;
}

/// Whether forward Euler is unstable, k h > 2, so that each step overshoots equilibrium by more
/// than the step before, and the change of T_b in this step is out of all proportion.
bool euler_diverged(const Params& params, double heating, double exposed, double change) {
  constexpr double kProportion = 100;
  const double k = params.air_conductance * exposed + params.contact_conductance * (1 - exposed);
  if (params.heat != HeatRule::euler || !(k * params.dt > 2)) return false;
  const double scale = std::max(
      {1.0, std::abs(params.ambient_temperature), std::abs(params.thermogenesis + heating) / k});
  return std::abs(change) > kProportion * scale;
}

}  // namespace

double heat_step(const Params& params, double tb, double exposed, double contact_mean,
                 double heating) {
  const double produced = params.thermogenesis + heating;
  const double to_air = params.air_conductance * exposed;
  const double to_others = exposed < 1 ? params.contact_conductance * (1 - exposed) : 0;
  // Differences come first: large opposite temperatures then do not cancel. A conductance of 0
  // exchanges nothing, even where the difference overflows.
  const double loss_to_air = to_air > 0 ? to_air * (tb - params.ambient_temperature) : 0;
  const double loss_to_others = to_others > 0 ? to_others * (tb - contact_mean) : 0;
  const double rate = produced - loss_to_air - loss_to_others;
  const bool exact = params.heat == HeatRule::exact;
  const double decay = (to_air + to_others) * params.dt;
  const double weight = exact && decay > 0 ? -expm1_fixed(-decay) / decay : 1;
  const double next = tb + params.dt * weight * rate;
  if (std::isfinite(next) && !(exact && decay > 1)) return next;
  return mean_after_step(params, tb, produced, to_air, to_others, contact_mean);
}

template <class Real>
Status heat(const Params& params, bool with_mean, const State<Real>& state, int pup, double& next) {
  assert(pup >= 0 && pup < state.pups);
  assert(with_mean || params.contact_conductance == 0 || state.pups == 1);
  const double exposed = state.exposed[pup];
  const double contact_mean = with_mean && exposed < 1 ? mean_touched_temperature(state, pup) : 0;
  const double heating = state.action(pup).heat;
  next = heat_step(params, state.tb[pup], exposed, contact_mean, heating);
  const auto bad = [&](Status::Kind kind) {
    return Status{kind, Stage::heat, state.step + 1, pup, -1};
  };
  if (!std::isfinite(next)) return bad(Status::Kind::non_finite);
  if (euler_diverged(params, heating, exposed, next - state.tb[pup]))
    return bad(Status::Kind::diverged);
  return {};
}

template Status heat<float>(const Params&, bool, const State<float>&, int, double&);
template Status heat<double>(const Params&, bool, const State<double>&, int, double&);

}  // namespace pupflow
