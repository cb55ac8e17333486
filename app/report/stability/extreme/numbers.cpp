// Extreme scenes of heat and sensors, and of a NaN.
#include <algorithm>
#include <cmath>

#include "app/report/stability/extreme/finding.h"
#include "app/report/stability/extreme/runs.h"

namespace pupflow::report::extreme {

Finding ambient(Precision precision, double ta, bool quick) {
  Params params = base(precision);
  params.ambient_temperature = ta;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, quick ? 2000 : 6000);
  const auto tb = simulation.view().tb;
  const auto [low, high] = std::minmax_element(tb.begin(), tb.end());
  // Between T_b(0) and T_a, or a little above, since a huddle keeps some of the heat that it makes.
  constexpr double kOwnHeat = 1;
  require(finding, "T_b from", *low,
          std::min(params.ambient_temperature, params.initial_temperature), 1e7);
  require(finding, "to", *high, -1e7,
          std::max(params.ambient_temperature, params.initial_temperature) + kOwnHeat);
  return finding;
}

Finding no_conductance(Precision precision, bool) {
  Params params = base(precision);
  params.air_conductance = params.contact_conductance = 0;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 1500);
  double error = 0;
  for (const double tb : simulation.view().tb) {
    error = std::max(error, std::abs(tb - (params.initial_temperature +
                                           params.thermogenesis * simulation.time())));
  }
  require(finding, "largest difference from T_b(0) + G t", error, 0, 1e-12);
  params.thermogenesis = 0;
  Simulation still(params);
  finding.ok = run_fine(still, 500).ok && finding.ok;
  double change = 0;
  for (const double tb : still.view().tb) {
    change = std::max(change, std::abs(tb - params.initial_temperature));
  }
  require(finding, "G = 0: largest change", change, 0, 0);
  return finding;
}

Finding stiff_euler(Precision precision, bool) {
  Params params = base(precision);
  params.heat = HeatRule::euler;
  params.air_conductance = 500;
  const Finding euler = run_until(params, 100, Status::Kind::diverged, Stage::heat);
  params.heat = HeatRule::exact;
  params.air_conductance = 1e300;
  Simulation exact(params);
  Finding finding = run_fine(exact, 100);
  double error = 0;
  for (const double tb : exact.view().tb)
    error = std::max(error, std::abs(tb - params.ambient_temperature));
  require(finding, "largest difference of T_b from T_a", error, 0, 1e-9);
  return both("Euler", euler, "Exact, k₁ = 1e300", finding);
}

Finding steep_sensors(Precision precision, bool) {
  Params params = base(precision);
  params.sensitivity = params.steering_gain = 1e300;
  Simulation simulation(params);
  return run_fine(simulation, 1500);
}

Finding sharp_sensors(Precision precision, bool) {
  Finding all{true, ""};
  for (const double sigma : {1e9, -1e9}) {
    Params params = base(precision);
    params.sensitivity = sigma;
    Simulation simulation(params);
    Finding finding = run_fine(simulation, 1500);
    const auto tb = simulation.view().tb;
    const auto [low, high] = std::minmax_element(tb.begin(), tb.end());
    require(finding, "T_b from", *low, params.ambient_temperature, 1);
    require(finding, "to", *high, params.ambient_temperature, 1);
    require(finding, "largest deformation energy", largest_energy(shapes_of(simulation)), 0, 0.01);
    all.ok = all.ok && finding.ok;
    all.happened += (sigma > 0 ? "10⁹: " : ". −10⁹: ") + finding.happened;
  }
  return all;
}

Finding burning_start(Precision precision, bool) {
  Params params = base(precision);
  params.initial_temperature = 1e300;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 1500);
  const auto tb = simulation.view().tb;
  const auto [low, high] = std::minmax_element(tb.begin(), tb.end());
  // The bounds of a pup that is fully exposed, and of one that is not exposed.
  require(finding, "T_b / T_b(0) from", *low / params.initial_temperature,
          0.999 * std::exp(-params.air_conductance * simulation.time()), 1);
  require(finding, "to", *high / params.initial_temperature, 0, 1);
  return finding;
}

Finding bad_point(Precision precision, bool) {
  Simulation simulation(base(precision));
  simulation.run(5);
  Points cloud = of_pup(simulation.view().positions, 7);
  cloud[123].y() = std::nan("");
  place(simulation, 7, cloud);
  const Status status = simulation.step();
  return {status.kind == Status::Kind::non_finite && status.step == 6 && status.pup == 7 &&
              status.point == 123,
          status.message()};
}

}  // namespace pupflow::report::extreme
