#include "bench/scalar_model.h"

#include <cmath>
#include <stdexcept>

namespace pupflow::bench {

void require_baseline_model(const Params& params) {
  constexpr double kLargestBeta = 0.9;  // beyond it the volume factor has another limit
  if (params.heading == Heading::course && params.integrator == Integrator::predictive &&
      params.heat == HeatRule::exact && params.refinement == Refinement::naive &&
      params.contact == ContactRule::nearest && params.deformation <= kLargestBeta) {
    return;
  }
  throw std::invalid_argument(
      "the baselines step contact = nearest, heading = course, integrator = predictive, heat = "
      "exact, refinement = naive and beta at most 0.9");
}

double turn_of(const Params& params, double tb, double left, double right) {
  const auto sensed = [&](double t) {
    return 1 / (1 + std::exp(-params.sensitivity * t * (params.preferred_temperature - tb)));
  };
  const double s_left = sensed(left), s_right = sensed(right);
  return std::atan(params.steering_gain * (s_left - s_right) / (s_left + s_right));
}

double warmed(const Params& params, double tb, double exposed, double touched_mean) {
  const double to_air = params.air_conductance * exposed;
  const double to_others = params.contact_conductance * (1 - exposed);
  const double rate = to_air + to_others;
  const double gain =
      params.thermogenesis + to_air * params.ambient_temperature + to_others * touched_mean;
  if (rate == 0) return tb + params.dt * gain;
  const double end = gain / rate;
  return end + (tb - end) * std::exp(-rate * params.dt);
}

double wrapped(double radians) {
  return std::atan2(std::sin(radians), std::cos(radians));
}

}  // namespace pupflow::bench
