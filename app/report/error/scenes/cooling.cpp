// Scene 5 of the error report: heat, where the closed form is known.
#include <cmath>

#include "app/report/error/sampling.h"
#include "app/report/error/scenes/scenes.h"
#include "app/report/error/settings.h"
#include "engine/bodies.h"
#include "engine/heat.h"

namespace pupflow::report {
namespace {

constexpr int kSamples = 50;  // one model second

/// One pup far from floor and wall: only its heat matters.
Params alone() {
  Params p = weightless_pup();
  p.initial_temperature = 1;
  p.ambient_temperature = 0.2;
  return p;
}

/// A share of 2/3 is exposed. The rest touches a neighbour whose T_b stays 0.5.
constexpr double kExposed = 2.0 / 3, kNeighbour = 0.5;

/// One pup goes through whole steps, and two through the heat rule alone with a fixed exposed share.
Outcome run(const Setting& setting) {
  Simulation simulation(setting.params);
  Params fast = setting.params, stiff = setting.params;
  fast.air_conductance = 100, fast.contact_conductance = 30;
  stiff.air_conductance = 1e4, stiff.contact_conductance = 1e4;
  double fast_tb = fast.initial_temperature, stiff_tb = stiff.initial_temperature;
  return run_sampled(
      simulation, kSamples, 3,
      [&](const LitterView& s, Trajectory& to) {
        to[0].push_back(s.tb[0]);
        to[1].push_back(fast_tb);
        to[2].push_back(stiff_tb);
      },
      [&](Simulation&) {
        fast_tb = heat_step(fast, fast_tb, kExposed, kNeighbour);
        stiff_tb = heat_step(stiff, stiff_tb, kExposed, kNeighbour);
      });
}

/// G - a (T - T_a) - b (T - T_c) from T(0) = T_b(0).
double temperature(const Params& p, double a, double b, double t) {
  const double end = (p.thermogenesis + a * p.ambient_temperature + b * kNeighbour) / (a + b);
  return end + (p.initial_temperature - end) * std::exp(-(a + b) * t);
}

void closed_form(Trajectory& right) {
  const Params p = alone();
  for (std::size_t i = 0; i < right[0].size(); ++i) {
    const double t = kSample * static_cast<double>(i + 1);
    right[0][i] = temperature(p, p.air_conductance, 0, t);
    right[1][i] = temperature(p, 100 * kExposed, 30 * (1 - kExposed), t);
    right[2][i] = temperature(p, 1e4 * kExposed, 1e4 * (1 - kExposed), t);
  }
}

}  // namespace

ErrorScene cooling_scene(bool quick) {
  ErrorScene scene;
  scene.name = "cooling";
  scene.title = "5. Cooling and heating";
  scene.about =
      "A pup with T_b = 1 cools alone at T_a = 0.2 for one second (k₁ = 0.9). The heat rule alone "
      "is also stepped for a pup with two thirds of its surface exposed and one third in contact "
      "with a neighbour whose T_b stays 0.5: once with k₁ = 100 and k₂ = 30, and once stiff, with "
      "k₁ = k₂ = 10⁴. All three have a closed form, an exponential approach to equilibrium. `heat "
      "= exact`, the default, is that form, so it has no row here: its error is rounding, and its "
      "step takes as long as one of `euler`. Euler is of first order. It grows without bound when "
      "the rate is above 2/h, which is 200 per second at the default step. So the errors of the "
      "stiff pup are large and not drawn.";
  scene.smallest_drawn = 1e-7;
  scene.quantities = {{"cooling", "T_b at k1 = 0.9"},
                      {"fast", "T_b at k1 = 100"},
                      {"stiff", "T_b at k1 = k2 = 10^4", 0, false}};
  const Params exact = alone();
  Params euler = exact;
  euler.heat = HeatRule::euler;
  // Only heat matters here, so refinement = naive saves time.
  scene.curves = {{"Euler", halved_naively(euler, quick ? 16 : 256), true}};
  scene.standard = {"dt = 0.01, exact, double", exact, 0};
  scene.standard_is_exact = true;
  set_reference(scene, exact, 1);
  scene.reference.label = "the closed form";
  scene.run = run;
  scene.closed_form = closed_form;
  return scene;
}

}  // namespace pupflow::report
