// Extreme scenes of the number of pups and of their distance from each other.
#include <algorithm>
#include <cmath>

#include "app/report/stability/extreme/finding.h"
#include "app/report/stability/extreme/runs.h"
#include "pupflow/observer.h"
#include "pupflow/overlap.h"

namespace pupflow::report::extreme {

using Eigen::Vector3d;

Finding pile(Precision precision, bool quick) {
  Params params = base(precision);
  params.pups = 200;
  params.arena_radius = 1;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, quick ? 300 : 8000);
  const auto shapes = shapes_of(simulation);
  double outside = 0;
  for (const Shape& shape : shapes) outside = std::max(outside, shape.centre.head<2>().norm());
  require(finding, "largest distance of a centre from the axis", outside, 0, params.arena_radius);
  require(finding, "touching pairs a pup",
          static_cast<double>(simulation.view().touching.size()) / params.pups, 0.5, 40);
  require(finding, "smallest volume", smallest_volume(shapes), 0.3, 1.1);
  return finding;
}

Finding soft_pile(Precision precision, bool) {
  Params params = base(precision);
  params.pups = 200;
  params.rigidity = 1;
  params.deformation = 0.99;
  params.gravity = 1000;
  return run_until(params, 400, Status::Kind::diverged, Stage::shape_match);
}

Finding narrow(Precision precision, bool) {
  Params params = base(precision);
  params.pups = 30;
  params.arena_radius = 0.6;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 1500);
  const auto shapes = shapes_of(simulation);
  require(finding, "largest deformation energy", largest_energy(shapes), 0, 0.01);
  require(finding, "share of points inside another body", measure_overlap(simulation).inside, 0.5,
          1);
  require(finding, "warnings", static_cast<double>(simulation.warnings().size()), 0, 0);
  return finding;
}

Finding giants(Precision precision, bool) {
  Params params = base(precision);
  params.pup_radius = 1.9;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 1500);
  const Overlap overlap = measure_overlap(simulation);
  require(finding, "nearest centre over 2 r_pup", overlap.nearest / (2 * params.pup_radius), 0,
          0.1);
  require(finding, "share of points inside another body", overlap.inside, 0.5, 1);
  require(finding, "largest deformation energy", largest_energy(shapes_of(simulation)), 0, 0.01);
  return finding;
}

Finding column(Precision precision, bool quick) {
  Params params = base(precision);
  params.pups = 10000;
  params.face_points = 2;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, quick ? 20 : 1000);
  require(finding, "touching pairs a pup",
          static_cast<double>(simulation.view().touching.size()) / params.pups, 0, 10);
  return finding;
}

Finding coincident(Precision precision, bool) {
  Params params = base(precision);
  params.pups = 2;
  Simulation simulation(params);
  place(simulation, 1, of_pup(simulation.view().positions, 0));
  Finding finding = run_fine(simulation, 3000);
  const auto shapes = shapes_of(simulation);
  require(finding, "largest deformation energy", largest_energy(shapes), 0, 0.1);
  return finding;
}

Finding no_pup(Precision precision, bool) {
  Params params = base(precision);
  params.pups = 0;
  Simulation simulation(params);
  Observer observer(simulation);
  Finding finding = run_fine(simulation, 1500);
  const Observables& seen = observer.observe(simulation);
  require(finding, "groups", seen.groups, 0, 0);
  return finding;
}

Finding alone(Precision precision, bool) {
  Params params = base(precision);
  params.pups = 1;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 3000);
  const double equilibrium =
      params.ambient_temperature + params.thermogenesis / params.air_conductance;
  const double expected = equilibrium + (params.initial_temperature - equilibrium) *
                                            std::exp(-params.air_conductance * simulation.time());
  require(finding, "difference from the closed form of T_b",
          std::abs(simulation.view().tb[0] - expected), 0, 1e-12);
  require(finding, "exposed", simulation.view().exposed[0], 1, 1);
  return finding;
}

Finding quiet_litter(Precision precision, bool quick) {
  Params params = base(precision);
  params.pups = 3;
  params.face_points = 3;
  params.drive = 0;
  params.start = Start::carpet;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 3000);
  const auto before = shapes_of(simulation);
  const std::int64_t steps = quick ? 200000 : 10000000;
  const Finding later = run_fine(simulation, steps);
  finding = {finding.ok && later.ok, later.happened};
  const auto after = shapes_of(simulation);
  double sideways = 0, up = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const Vector3d moved = after[i].centre - before[i].centre;
    sideways = std::max(sideways, moved.head<2>().norm());
    up = std::max(up, std::abs(moved.z()));
  }
  require(finding, "largest deformation energy", largest_energy(after), 0, 0.01);
  require(finding, "smallest volume", smallest_volume(after), 0.9, 1.1);
  require(finding, "change of height", up, 0, 0.5);
  require(finding, "moved sideways", sideways, 0, 2 * params.arena_radius);
  return finding;
}

}  // namespace pupflow::report::extreme
