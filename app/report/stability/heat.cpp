#include "app/report/stability/heat.h"

#include <cmath>

#include "engine/bodies.h"

namespace pupflow::report {
namespace {

constexpr double kApart = 1.6;   // centres of the held pups, in pup radii
constexpr double kWarmer = 0.1;  // the first of them

/// How a difference goes to 0, step by step.
class Decay {
 public:
  explicit Decay(double first) : first_(first), before_(first) {}

  /// Takes the next value; false once it is of the size of rounding.
  bool add(double now) {
    if (std::abs(now) < 1e-9 * std::abs(first_)) return false;
    turns_ += now * before_ < 0 ? 1 : 0;
    ++steps_;
    before_ = now;
    return true;
  }

  Trial classify() const {
    Trial trial;
    if (2 * turns_ > steps_) trial.verdict = Verdict::ringing;
    // A factor of -1 keeps its size up to rounding.
    if (std::abs(before_) > (1 + 1e-9) * std::abs(first_)) trial.verdict = Verdict::diverged;
    return trial;
  }

 private:
  double first_, before_;
  std::int64_t turns_ = 0, steps_ = 0;
};

/// Puts the two pups side by side, far above the floor, at rest.
void hold(Simulation& simulation) {
  const Params& params = simulation.params();
  const Points rest = rest_points(params);
  for (int pup = 0; pup < 2; ++pup) {
    const double x = (pup - 0.5) * kApart * params.pup_radius;
    place(simulation, pup, shifted(rest, {x, 0, 4 * params.pup_radius}));
  }
}

}  // namespace

std::optional<Trial> try_heat(const Params& params, const std::function<bool()>& stop) {
  if (stop()) return std::nullopt;
  Simulation simulation(params);
  const double equilibrium =
      params.ambient_temperature + params.thermogenesis / params.air_conductance;
  Decay decay(params.initial_temperature - equilibrium);
  while (simulation.steps_done() < params.steps) {
    const Status status = simulation.step();
    if (!status.ok()) return lost(status);
    if (!decay.add(simulation.view().tb[0] - equilibrium)) break;
  }
  return decay.classify();
}

std::optional<Trial> try_exchange(const Params& params, const std::function<bool()>& stop) {
  if (stop()) return std::nullopt;
  Simulation simulation(params);
  simulation.set_body_temperature(0, params.initial_temperature + kWarmer);
  Decay decay(kWarmer);
  while (simulation.steps_done() < params.steps) {
    hold(simulation);
    const Status status = simulation.step();
    if (!status.ok()) return lost(status);
    const auto tb = simulation.view().tb;
    if (!decay.add(tb[0] - tb[1])) break;
  }
  return decay.classify();
}

double held_contact(const Params& params) {
  Simulation simulation(params);
  hold(simulation);
  simulation.step();
  return 1 - simulation.view().exposed[0];
}

}  // namespace pupflow::report
