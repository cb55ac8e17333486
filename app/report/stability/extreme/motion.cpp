// Extreme scenes of falls, steps and drive.
#include <algorithm>
#include <cmath>

#include "app/report/stability/extreme/finding.h"
#include "app/report/stability/extreme/runs.h"

namespace pupflow::report::extreme {

using Eigen::Vector3d;

Finding drop(Precision precision, bool) {
  Params params = base(precision);
  params.pups = 1;
  params.drive = 0;
  Simulation simulation(params);
  constexpr double kHeight = 1e4;
  place(simulation, 0, shifted(of_pup(simulation.view().positions, 0), {0, 0, kHeight}));
  const double start = simulation.view().positions.mean(0).z();
  Finding finding = run_fine(simulation, 4000);
  // v_n = -n g h and z_n = z_0 - g h^2 n (n + 1) / 2, exactly, for the scheme.
  const double fallen = params.gravity * params.dt * params.dt * 4000 * 4001 / 2;
  const double error = std::abs(start - simulation.view().positions.mean(0).z() - fallen) / fallen;
  require(finding, "relative error of the fall", error, 0, is_double(precision) ? 1e-10 : 1e-3);
  double highest = 0, energy = 0;
  for (int bounce = 0; bounce < 10 && finding.ok; ++bounce) {
    finding.ok = simulation.run(1000).ok();
    highest = std::max(highest, simulation.view().positions.mean(0).z());
    energy = std::max(energy, largest_energy(shapes_of(simulation)));
  }
  require(finding, "bouncing, highest", highest, 0.5 * kHeight, 1.5 * kHeight);
  require(finding, "largest deformation energy", energy, 0, 0.01);
  return finding;
}

Finding heavy(Precision precision, bool) {
  Params params = base(precision);
  params.gravity = 1e5;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 2000);
  require(finding, "largest deformation energy", largest_energy(shapes_of(simulation)), 0.01, 1e4);
  return finding;
}

Finding heavy_scaled(Precision precision, bool) {
  Params params = base(precision);
  params.pups = 1;
  params.drive = params.start_spread = 0;
  Params scaled = params;
  scaled.gravity *= 1e4;
  scaled.dt /= 100;
  Simulation ordinary(params), heavy(scaled);
  ordinary.run(150);
  Finding finding = run_fine(heavy, 150);
  double difference = 0;
  const Points a = of_pup(ordinary.view().positions, 0), b = of_pup(heavy.view().positions, 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = std::max(difference, (a[i] - b[i]).norm());
  }
  require(finding, "largest difference from g = 10, h = 0.01", difference, 0,
          is_double(precision) ? 1e-9 : 1e-2);
  return finding;
}

Finding tiny_step(Precision precision, bool) {
  Params params = base(precision);
  params.dt = 1e-8;
  if (!is_double(precision)) {
    const std::vector<Problem> problems = check(params);
    return {problems.size() == 1 && problems[0].parameter == "dt",
            "refused: " + (problems.empty() ? "not at all" : problems[0].message)};
  }
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 5000);
  require(finding, "largest deformation energy", largest_energy(shapes_of(simulation)), 0, 1e-20);
  double error = 0;
  for (const Vector3d& v : of_all(simulation.view().velocities)) {
    error = std::max(error, std::abs(v.z() + params.gravity * simulation.time()));
  }
  require(finding, "largest difference of v_z from −g t", error, 0, 1e-5);
  return finding;
}

Finding longer_step(Precision precision, double dt, bool) {
  Params params = base(precision);
  params.dt = dt;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 1500);
  // 0.1: a step falls g h^2 = 0.1, and the floor pushes whole bodies together.
  constexpr double kShort = 0.04, kLong = 0.08, kOrdinary = 0.1;
  const double energy = largest_energy(shapes_of(simulation));
  require(finding, "largest deformation energy", energy, dt < kShort ? 0 : 0.005,
          dt < kLong ? kOrdinary * dt / kShort : 10);
  const bool sunk = warned(simulation, Warning::Kind::sunk), expected = dt > kLong;
  finding.ok = finding.ok && sunk == expected;
  return finding;
}

Finding huge_step(Precision precision, bool) {
  Params driven = base(precision);
  driven.dt = 1;
  driven.drive = 1;
  Params still = driven;
  still.drive = 0;
  return fine_but({"no drive", still, 200}, {"drive 1", driven, 100}, Status::Kind::escaped,
                  Stage::shape_match);
}

Finding wild_drive(Precision precision, bool) {
  Params params = base(precision);
  params.drive = 1e5;
  return run_until(params, 1500, Status::Kind::escaped, Stage::shape_match);
}

}  // namespace pupflow::report::extreme
