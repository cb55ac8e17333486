// Extreme scenes of single bodies: stiffness, initial deformation, number and size of points.
#include "app/report/stability/extreme/finding.h"
#include "app/report/stability/extreme/runs.h"
#include "pupflow/overlap.h"

namespace pupflow::report::extreme {

using Eigen::Vector3d;

namespace {

/// A weightless cloud deformed by `map` at first, so that only shape matching acts.
Finding deformed(Precision precision, const Eigen::Matrix3d& map) {
  Finding all{true, ""};
  for (const double beta : {0.0, 0.5}) {
    Params params = weightless(precision);
    params.deformation = beta;
    Simulation simulation(params);
    Points cloud = of_pup(simulation.view().positions, 0);
    const Vector3d centre = simulation.view().positions.mean(0);
    for (Vector3d& point : cloud) point = centre + map * (point - centre);
    place(simulation, 0, cloud);
    Finding finding = run_fine(simulation, 200);
    const Shape shape = shapes_of(simulation).front();
    require(finding, "deformation energy", shape.energy, 0, 1e-5);
    require(finding, "volume", shape.volume, 0.99, 1.01);
    all.ok = all.ok && finding.ok;
    all.happened += (beta > 0 ? ". β = 0.5: " : "β = 0: ") + finding.happened;
  }
  return all;
}

}  // namespace

Finding alpha_beta(Precision precision, double alpha, double beta, Integrator integrator,
                   bool quick) {
  Params params = base(precision);
  params.rigidity = alpha;
  params.deformation = beta;
  params.integrator = integrator;
  Simulation simulation(params);
  const std::int64_t steps = quick ? 600 : 3000;
  const Status status = simulation.run(steps);
  const double energy = largest_energy(shapes_of(simulation));
  if (integrator == Integrator::explicit_) {
    // Undamped: it is either fine or ends in a status that names the step.
    Finding finding{status.ok() ? finite(simulation) : status.step == simulation.steps_done() + 1,
                    status.message()};
    if (alpha > 0) finding.ok = finding.ok && status.kind == Status::Kind::diverged;
    add_warnings(finding, simulation);
    return finding;
  }
  Finding finding{status.ok() && finite(simulation),
                  std::to_string(steps) + " steps, " + status.message()};
  add_warnings(finding, simulation);
  const double rigid = is_double(precision) ? 1e-20 : 1e-10;
  if (alpha == 1 && beta == 0) {
    require(finding, "deformation energy", energy, 0, rigid);
  } else {
    require(finding, "deformation energy", energy, 0, 1000);
  }
  return finding;
}

Finding flat(Precision precision, bool) {
  return deformed(precision, Vector3d(1, 1, 0).asDiagonal());
}

Finding line(Precision precision, bool) {
  return deformed(precision, Vector3d(1, 0, 0).asDiagonal());
}

Finding point(Precision precision, bool) {
  return deformed(precision, Eigen::Matrix3d::Zero());
}

Finding mirrored(Precision precision, bool) {
  return deformed(precision, Vector3d(1, 1, -1).asDiagonal());
}

Finding resolution(Precision precision, int face_points, bool quick) {
  Params params = base(precision);
  params.face_points = face_points;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, face_points > 10 && quick ? 200 : 1500);
  const auto shapes = shapes_of(simulation);
  require(finding, "largest deformation energy", largest_energy(shapes), 0, 0.1);
  require(finding, "smallest volume", smallest_volume(shapes), 0.5, 1.1);
  return finding;
}

Finding fat_points(Precision precision, bool) {
  Params twelve = base(precision);
  twelve.point_radius = 0.5;
  twelve.pups = 12;
  Params sums = twelve;
  sums.contact = ContactRule::sum;
  return fine_but({"nearest", twelve, 1000}, {"Sum", sums, 1000}, Status::Kind::diverged,
                  Stage::contact);
}

Finding large_points(Precision precision, bool) {
  Params params = base(precision);
  params.point_radius = 0.2;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 1500);
  require(finding, "largest deformation energy", largest_energy(shapes_of(simulation)), 0, 0.01);
  const Overlap overlap = measure_overlap(simulation);
  require(finding, "share of points inside another body", overlap.inside, 0, 0.01);
  require(finding, "warnings", static_cast<double>(simulation.warnings().size()), 0, 0);
  return finding;
}

}  // namespace pupflow::report::extreme
