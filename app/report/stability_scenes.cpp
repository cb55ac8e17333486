#include "app/report/stability_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/report/report.h"
#include "app/report/stability_measure.h"
#include "engine/metrics.h"

namespace pupflow::report {
namespace {

using Eigen::Vector3d;
using Cloud3 = std::vector<Vector3d>;

Params base(Precision precision) {
  Params params;
  params.precision = precision;
  return params;
}

/// One pup far from floor and wall that nothing pushes.
Params weightless(Precision precision) {
  Params params = base(precision);
  params.pups = 1;
  params.gravity = params.drive = 0;
  params.arena_radius = 1000;
  return params;
}

bool is_double(Precision precision) {
  return precision == Precision::double_;
}

bool finite(const Simulation& simulation) {
  std::vector<double> xyz(3 * static_cast<std::size_t>(simulation.pups()) * simulation.points());
  const auto all = [](const auto& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  };
  simulation.copy_positions(std::span<double>(xyz));
  if (!all(xyz)) return false;
  simulation.copy_velocities(xyz);
  return all(xyz) && all(simulation.body_temperature()) && all(simulation.heading()) &&
         all(simulation.exposed());
}

double largest_energy(const std::vector<Shape>& shapes) {
  double energy = 0;
  for (const Shape& shape : shapes) energy = std::max(energy, shape.energy);
  return energy;
}

double smallest_volume(const std::vector<Shape>& shapes) {
  double volume = 1e300;
  for (const Shape& shape : shapes) volume = std::min(volume, shape.volume);
  return volume;
}

/// Runs and says how it ended; ok when no number went bad and all are finite.
Finding run_fine(Simulation& simulation, std::int64_t steps) {
  constexpr std::int64_t kAtOnce = 1000;
  for (std::int64_t done = 0; done < steps; done += kAtOnce) {
    stop_if_interrupted();
    const Status status = simulation.run(std::min(kAtOnce, steps - done));
    if (!status.ok()) return {false, status.message()};
  }
  return {finite(simulation), std::to_string(steps) + " steps, all numbers finite"};
}

/// Adds a number that must be within limits.
void demand(Finding& finding, const std::string& what, double value, double low, double high) {
  finding.ok = finding.ok && value >= low && value <= high;
  finding.happened += "; " + what + " " + rounded(value);
}

/// Runs until a status of this kind and stage; ok when it comes.
Finding run_until(const Params& params, std::int64_t steps, Status::Kind kind, Stage stage) {
  Simulation simulation(params);
  const Status status = simulation.run(steps);
  return {
      status.kind == kind && status.stage == stage && status.step == simulation.steps_done() + 1,
      status.ok() ? "fine after " + std::to_string(steps) + " steps" : status.message()};
}

void place(Simulation& simulation, int pup, const Cloud3& cloud,
           const Vector3d& velocity = {0, 0, 0}) {
  std::vector<double> x, v;
  for (const Vector3d& point : cloud) {
    x.insert(x.end(), {point.x(), point.y(), point.z()});
    v.insert(v.end(), {velocity.x(), velocity.y(), velocity.z()});
  }
  simulation.set_cloud(pup, x, v);
}

Cloud3 cloud_of(const Simulation& simulation, int pup) {
  const auto points = static_cast<std::size_t>(simulation.points());
  std::vector<double> xyz(3 * points * static_cast<std::size_t>(simulation.pups()));
  simulation.copy_positions(std::span<double>(xyz));
  Cloud3 cloud(points);
  for (std::size_t i = 0; i < points; ++i) {
    const double* p = xyz.data() + 3 * (points * static_cast<std::size_t>(pup) + i);
    cloud[i] = {p[0], p[1], p[2]};
  }
  return cloud;
}

// Crowds ----------------------------------------------------------------------------------------

Finding pile(Precision precision, bool quick) {
  Params params = base(precision);
  params.pups = 200;
  params.arena_radius = 1;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, quick ? 300 : 8000);
  const auto shapes = shapes_of(simulation);
  double outside = 0;
  for (const Shape& shape : shapes) outside = std::max(outside, shape.centre.head<2>().norm());
  demand(finding, "furthest centre from the axis", outside, 0, params.arena_radius);
  demand(finding, "touching pairs a pup",
         static_cast<double>(simulation.touching().size()) / params.pups, 0.5, 10);
  demand(finding, "smallest volume", smallest_volume(shapes), 0.3, 1.1);
  return finding;
}

Finding column(Precision precision, bool quick) {
  Params params = base(precision);
  params.pups = 10000;
  params.face_points = 2;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, quick ? 20 : 1000);
  demand(finding, "touching pairs a pup",
         static_cast<double>(simulation.touching().size()) / params.pups, 0, 10);
  return finding;
}

Finding coincident(Precision precision, bool) {
  Params params = base(precision);
  params.pups = 2;
  Simulation simulation(params);
  place(simulation, 1, cloud_of(simulation, 0));
  Finding finding = run_fine(simulation, 3000);
  const auto shapes = shapes_of(simulation);
  demand(finding, "largest deformation energy", largest_energy(shapes), 0, 0.1);
  return finding;
}

// Falls -----------------------------------------------------------------------------------------

Finding drop(Precision precision, bool) {
  Params params = base(precision);
  params.pups = 1;
  params.drive = 0;
  Simulation simulation(params);
  constexpr double kHeight = 1e4;
  Cloud3 cloud = cloud_of(simulation, 0);
  for (Vector3d& point : cloud) point.z() += kHeight;
  place(simulation, 0, cloud);
  const double start = simulation.centre(0).z();
  Finding finding = run_fine(simulation, 4000);
  // v_n = -n g h and z_n = z_0 - g h^2 n (n + 1) / 2, exactly, for the scheme.
  const double fallen = params.gravity * params.dt * params.dt * 4000 * 4001 / 2;
  const double error = std::abs(start - simulation.centre(0).z() - fallen) / fallen;
  demand(finding, "relative error of the fall", error, 0, is_double(precision) ? 1e-10 : 1e-3);
  double highest = 0, energy = 0;
  for (int bounce = 0; bounce < 10 && finding.ok; ++bounce) {
    finding.ok = simulation.run(1000).ok();
    highest = std::max(highest, simulation.centre(0).z());
    energy = std::max(energy, largest_energy(shapes_of(simulation)));
  }
  demand(finding, "bouncing, highest", highest, 0.5 * kHeight, 1.5 * kHeight);
  demand(finding, "largest deformation energy", energy, 0, 0.01);
  return finding;
}

Finding heavy(Precision precision, bool) {
  Params params = base(precision);
  params.gravity = 1e5;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 2000);
  demand(finding, "largest deformation energy", largest_energy(shapes_of(simulation)), 0.01, 1e4);
  return finding;
}

/// g h^2 and alpha are the same as in the ordinary fall: the same positions, step by step.
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
  const Cloud3 a = cloud_of(ordinary, 0), b = cloud_of(heavy, 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = std::max(difference, (a[i] - b[i]).norm());
  }
  demand(finding, "largest difference from g = 10, h = 0.01", difference, 0,
         is_double(precision) ? 1e-9 : 1e-2);
  return finding;
}

// Bodies ----------------------------------------------------------------------------------------

Finding alpha_beta(Precision precision, double alpha, double beta, Integrator integrator,
                   bool quick) {
  Params params = base(precision);
  params.alpha = alpha;
  params.beta = beta;
  params.integrator = integrator;
  Simulation simulation(params);
  const std::int64_t steps = quick ? 600 : 3000;
  const Status status = simulation.run(steps);
  const double energy = largest_energy(shapes_of(simulation));
  if (integrator == Integrator::explicit_) {
    // Undamped: what counts is that it is either fine or named.
    Finding finding{status.ok() ? finite(simulation) : status.step == simulation.steps_done() + 1,
                    status.message()};
    if (alpha > 0) finding.ok = finding.ok && status.kind == Status::Kind::diverged;
    return finding;
  }
  Finding finding{status.ok() && finite(simulation),
                  std::to_string(steps) + " steps, " + status.message()};
  const double rigid = is_double(precision) ? 1e-20 : 1e-10;
  if (alpha == 1 && beta == 0) {
    demand(finding, "deformation energy", energy, 0, rigid);
  } else {
    demand(finding, "deformation energy", energy, 0, 1000);
  }
  return finding;
}

template <int Alpha, int Beta, Integrator Which>
Finding corner(Precision precision, bool quick) {
  return alpha_beta(precision, Alpha, Beta, Which, quick);
}

/// A cloud deformed by `map` and left alone; weightless, so only shape matching acts.
Finding deformed(Precision precision, const Eigen::Matrix3d& map) {
  Finding all{true, ""};
  for (const double beta : {0.0, 0.5}) {
    Params params = weightless(precision);
    params.beta = beta;
    Simulation simulation(params);
    Cloud3 cloud = cloud_of(simulation, 0);
    const Vector3d centre = simulation.centre(0);
    for (Vector3d& point : cloud) point = centre + map * (point - centre);
    place(simulation, 0, cloud);
    Finding finding = run_fine(simulation, 200);
    const Shape shape = shapes_of(simulation).front();
    demand(finding, "deformation energy", shape.energy, 0, 1e-5);
    demand(finding, "volume", shape.volume, 0.99, 1.01);
    all.ok = all.ok && finding.ok;
    all.happened += (beta > 0 ? ". β = 0.5: " : "β = 0: ") + finding.happened;
  }
  return all;
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

template <int FacePoints>
Finding resolution(Precision precision, bool quick) {
  Params params = base(precision);
  params.face_points = FacePoints;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, FacePoints > 10 && quick ? 200 : 1500);
  const auto shapes = shapes_of(simulation);
  demand(finding, "largest deformation energy", largest_energy(shapes), 0, 0.1);
  demand(finding, "smallest volume", smallest_volume(shapes), 0.5, 1.1);
  return finding;
}

Finding fat_points(Precision precision, bool) {
  Params params = base(precision);
  params.point_radius = 0.5;
  params.pups = 1;
  Simulation alone(params);
  Finding finding = run_fine(alone, 1000);
  params.pups = 12;
  const Finding together = run_until(params, 1000, Status::Kind::diverged, Stage::contact);
  return {finding.ok && together.ok,
          "one pup: " + finding.happened + ". Twelve: " + together.happened};
}

// Heat ------------------------------------------------------------------------------------------

template <int Sign>
Finding ambient(Precision precision, bool quick) {
  Params params = base(precision);
  params.ta = Sign * 1e6;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, quick ? 2000 : 6000);
  const auto tb = simulation.body_temperature();
  const auto [low, high] = std::minmax_element(tb.begin(), tb.end());
  // Between T_b(0) and T_a, or a little above: a huddle keeps some of the heat that it makes.
  constexpr double kOwnHeat = 1;
  demand(finding, "T_b from", *low, std::min(params.ta, params.tb0), 1e7);
  demand(finding, "to", *high, -1e7, std::max(params.ta, params.tb0) + kOwnHeat);
  return finding;
}

Finding no_conductance(Precision precision, bool) {
  Params params = base(precision);
  params.k1 = params.k2 = 0;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 1500);
  double error = 0;
  for (const double tb : simulation.body_temperature()) {
    error = std::max(error, std::abs(tb - (params.tb0 + params.g * simulation.time())));
  }
  demand(finding, "largest difference from T_b(0) + G t", error, 0, 1e-12);
  params.g = 0;
  Simulation still(params);
  finding.ok = run_fine(still, 500).ok && finding.ok;
  double change = 0;
  for (const double tb : still.body_temperature()) {
    change = std::max(change, std::abs(tb - params.tb0));
  }
  demand(finding, "G = 0: largest change", change, 0, 0);
  return finding;
}

Finding stiff_euler(Precision precision, bool) {
  Params params = base(precision);
  params.heat = HeatRule::euler;
  params.k1 = 500;
  const Finding euler = run_until(params, 100, Status::Kind::diverged, Stage::heat);
  params.heat = HeatRule::exact;
  params.k1 = 1e300;
  Simulation exact(params);
  Finding finding = run_fine(exact, 100);
  double error = 0;
  for (const double tb : exact.body_temperature())
    error = std::max(error, std::abs(tb - params.ta));
  demand(finding, "largest difference of T_b from T_a", error, 0, 1e-9);
  return {euler.ok && finding.ok,
          "Euler: " + euler.happened + ". Exact, k₁ = 1e300: " + finding.happened};
}

Finding steep_sensors(Precision precision, bool) {
  Params params = base(precision);
  params.sigma = params.v = 1e300;
  Simulation simulation(params);
  return run_fine(simulation, 1500);
}

// Small and large -------------------------------------------------------------------------------

Finding nobody(Precision precision, bool) {
  Params params = base(precision);
  params.pups = 0;
  Simulation simulation(params);
  Observer observer(simulation);
  Finding finding = run_fine(simulation, 1500);
  const Observables& seen = observer.observe(simulation);
  demand(finding, "groups", seen.groups, 0, 0);
  return finding;
}

Finding alone(Precision precision, bool) {
  Params params = base(precision);
  params.pups = 1;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 3000);
  const double equilibrium = params.ta + params.g / params.k1;
  const double expected =
      equilibrium + (params.tb0 - equilibrium) * std::exp(-params.k1 * simulation.time());
  demand(finding, "difference from the closed form of T_b",
         std::abs(simulation.body_temperature()[0] - expected), 0, 1e-12);
  demand(finding, "exposed", simulation.exposed()[0], 1, 1);
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
  demand(finding, "largest deformation energy", largest_energy(shapes_of(simulation)), 0, 1e-20);
  std::vector<double> v(3 * static_cast<std::size_t>(simulation.pups()) * simulation.points());
  simulation.copy_velocities(v);
  double error = 0;
  for (std::size_t i = 2; i < v.size(); i += 3) {
    error = std::max(error, std::abs(v[i] + params.gravity * simulation.time()));
  }
  demand(finding, "largest difference of v_z from −g t", error, 0, 1e-5);
  return finding;
}

Finding huge_step(Precision precision, bool) {
  Params params = base(precision);
  params.dt = 1;
  params.drive = 0;
  Simulation simulation(params);
  Finding finding = run_fine(simulation, 200);
  params.drive = 1;
  const Finding driven = run_until(params, 100, Status::Kind::escaped, Stage::shape_match);
  return {finding.ok && driven.ok,
          "no drive: " + finding.happened + ". drive 1: " + driven.happened};
}

Finding wild_drive(Precision precision, bool) {
  Params params = base(precision);
  params.drive = 1e5;
  return run_until(params, 1500, Status::Kind::escaped, Stage::shape_match);
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
  demand(finding, "largest deformation energy", largest_energy(after), 0, 0.01);
  demand(finding, "smallest volume", smallest_volume(after), 0.9, 1.1);
  demand(finding, "change of height", up, 0, 0.5);
  demand(finding, "moved sideways", sideways, 0, 2 * params.arena_radius);
  return finding;
}

Finding bad_point(Precision precision, bool) {
  Simulation simulation(base(precision));
  simulation.run(5);
  Cloud3 cloud = cloud_of(simulation, 7);
  cloud[123].y() = std::nan("");
  place(simulation, 7, cloud);
  const Status status = simulation.step();
  return {status.kind == Status::Kind::non_finite && status.step == 6 && status.pup == 7 &&
              status.point == 123,
          status.message()};
}

constexpr Integrator kPredictive = Integrator::predictive, kExplicit = Integrator::explicit_;

constexpr std::array kScenes{
    ExtremeScene{"pile", "200 pups in an arena of radius 1",
                 "Numbers stay fine, nobody leaves, and each pup touches few others.", pile},
    ExtremeScene{"column", "10,000 pups in one column",
                 "Only neighbours are searched: steps stay short, and numbers fine.", column},
    ExtremeScene{
        "coincident", "two pups at the very same points",
        "Distance 0 is no division by 0; ties go to the lower pup, and both keep their shape.",
        coincident},
    ExtremeScene{
        "drop", "one pup dropped from a height of 10⁴",
        "It falls as the closed form says. At 450 a second the floor turns all points round within "
        "one step, so it bounces about as high again, and keeps its shape.",
        drop},
    ExtremeScene{"heavy", "gravity 10⁵, h = 0.01",
                 "A step falls g h² = 10, which is 40 radii: the floor flattens every pup in every "
                 "step, crushed but finite.",
                 heavy},
    ExtremeScene{"heavy_scaled", "gravity 10⁵, h = 10⁻⁴",
                 "g h² is the ordinary one, so the fall and the landing are, too.", heavy_scaled},
    ExtremeScene{"alpha0_beta0", "α = 0, β = 0", "A loose cloud: scattered, but finite.",
                 corner<0, 0, kPredictive>},
    ExtremeScene{"alpha0_beta1", "α = 0, β = 1", "The same: without α, β means nothing.",
                 corner<0, 1, kPredictive>},
    ExtremeScene{"alpha1_beta0", "α = 1, β = 0", "Rigid: no deformation beyond rounding.",
                 corner<1, 0, kPredictive>},
    ExtremeScene{"alpha1_beta1", "α = 1, β = 1",
                 "No shape of their own: bodies spread over the floor, and do not grow.",
                 corner<1, 1, kPredictive>},
    ExtremeScene{"explicit_alpha0_beta0", "α = 0, β = 0, explicit",
                 "The same loose cloud; nothing can be undamped without α.",
                 corner<0, 0, kExplicit>},
    ExtremeScene{"explicit_alpha1_beta0", "α = 1, β = 0, explicit",
                 "Undamped, it diverges, and the step says so.", corner<1, 0, kExplicit>},
    ExtremeScene{"explicit_alpha1_beta1", "α = 1, β = 1, explicit",
                 "Undamped, it diverges, and the step says so.", corner<1, 1, kExplicit>},
    ExtremeScene{"flat", "a cloud started flat", "It gets its shape back.", flat},
    ExtremeScene{"line", "a cloud started as a line", "It gets its shape back, turned somehow.",
                 line},
    ExtremeScene{"point", "a cloud started as a point", "It gets its shape back, turned somehow.",
                 point},
    ExtremeScene{
        "mirrored", "a cloud started inside out",
        "It gets its shape back with the right handedness: rotations are never reflections.",
        mirrored},
    ExtremeScene{"k2", "24 points a pup (k = 2)", "Ordinary shapes.", resolution<2>},
    ExtremeScene{"k32", "6144 points a pup (k = 32)", "Ordinary shapes.", resolution<32>},
    ExtremeScene{"fat_points", "r_point = 0.5 above r_pup = 0.25",
                 "One pup is fine. Of two that touch, each point touches most of the other's, "
                 "displacements add up to many radii, and the contact stage says so.",
                 fat_points},
    ExtremeScene{"freezing", "T_a = −10⁶",
                 "T_b goes there and not beyond, but for the heat that a huddle makes itself.",
                 ambient<-1>},
    ExtremeScene{"burning", "T_a = 10⁶",
                 "T_b goes there and not beyond, but for the heat that a huddle makes itself.",
                 ambient<1>},
    ExtremeScene{"no_conductance", "k₁ = k₂ = 0", "T_b = T_b(0) + G t; with G = 0, T_b(0).",
                 no_conductance},
    ExtremeScene{
        "stiff_heat", "k₁ = 500 by Euler, 10³⁰⁰ exactly",
        "Euler overshoots by more each step, and the heat stage says so; the exact solution "
        "is at T_a at once.",
        stiff_euler},
    ExtremeScene{"steep_sensors", "σ = v = 10³⁰⁰", "Headings stay finite.", steep_sensors},
    ExtremeScene{"nobody", "no pup", "Steps do nothing.", nobody},
    ExtremeScene{"alone", "one pup", "It touches nobody; T_b follows its closed form.", alone},
    ExtremeScene{"tiny_step", "h = 10⁻⁸",
                 "It falls from rest by v = −g t. Single precision is refused: its rounding, "
                 "divided by h, would push the pups.",
                 tiny_step},
    ExtremeScene{
        "huge_step", "h = 1",
        "Crushed like gravity 10⁵, but finite; with drive, f h > 2/3 outruns the wall, and "
        "the step says so.",
        huge_step},
    ExtremeScene{"wild_drive", "drive 10⁵", "f h > 2/3 outruns the wall, and the step says so.",
                 wild_drive},
    ExtremeScene{"quiet", "ten million steps of three quiet pups (200,000 with --quick)",
                 "Heights and shapes stay as they are. Sideways they wander within the arena, "
                 "pushed by contacts and rounding, since nothing on the floor slows them.",
                 quiet_litter},
    ExtremeScene{"bad_point", "a NaN put into one point",
                 "The next step names step, pup and point.", bad_point},
};

}  // namespace

std::span<const ExtremeScene> extreme_scenes() {
  return kScenes;
}

}  // namespace pupflow::report
