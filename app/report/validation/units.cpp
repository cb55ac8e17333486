// The same litter in other units of length. The model changes, since its rules are not
// dimensionally consistent.
#include "app/report/validation/units.h"
#include "app/report/statistics.h"
#include "app/report/validation/sections.h"
#include "engine/bodies.h"

namespace pupflow::report {
namespace {

std::vector<double> measure_scaled(const Params& params) {
  Simulation simulation = scaled_litter(params, params.pup_radius / Params{}.pup_radius);
  RunMeans means(params.discard);
  Observer observer(simulation);
  double highest = 0;
  while (simulation.steps_done() < params.steps) {
    step_on(simulation);
    means.add(simulation, observer.observe(simulation));
    if (simulation.steps_done() <= params.discard) continue;
    for (int pup = 0; pup < params.pups; ++pup) {
      highest = std::max(highest, simulation.view().positions.mean(pup).z() / params.pup_radius);
    }
  }
  std::vector<double> numbers = statistics_of(means);
  numbers.push_back(highest);
  return numbers;
}

}  // namespace

Params in_unit(Params params, double scale) {
  for (double* length : {&params.arena_radius, &params.pup_radius, &params.point_radius,
                         &params.start_spread, &params.gravity, &params.drive}) {
    *length *= scale;
  }
  return params;
}

Simulation scaled_litter(const Params& params, double scale) {
  const Simulation ordinary(in_unit(params, 1 / scale));
  Simulation simulation(params);
  for (int pup = 0; pup < params.pups; ++pup) {
    Points points = of_pup(ordinary.view().positions, pup);
    for (Eigen::Vector3d& point : points) point *= scale;
    place(simulation, pup, points);
  }
  return simulation;
}

Parting part_by_unit(const Params& params, double scale, std::int64_t most) {
  Simulation ordinary(params);
  Simulation scaled = scaled_litter(in_unit(params, scale), scale);
  Parting parting;
  while (ordinary.steps_done() < most && parting.step == 0) {
    step_on(ordinary);
    step_on(scaled);
    if (parting.contact == 0 && !ordinary.view().touching.empty()) {
      parting.contact = ordinary.steps_done();
    }
    for (int pup = 0; pup < params.pups; ++pup) {
      const Eigen::Vector3d here = ordinary.view().positions.mean(pup);
      if ((scaled.view().positions.mean(pup) / scale - here).norm() > 1e-6)
        parting.step = ordinary.steps_done();
    }
  }
  return parting;
}

void units_section(Report& report) {
  const Options& options = report.options();
  report.heading("Another unit of length");
  report.text(
      "All lengths, gravity and drive are multiplied by a factor, from the same start: this is the "
      "same litter in another unit of length. The rules of the model are not the same. A contact "
      "displaces a point by (p_a − p_b)(2 r_point − d), a length times a length, so for lengths "
      "ten times as large it is a hundred times as large. A wall adds a velocity of ½ in any unit. "
      "(The velocity that a contact sets, p_b − p_a, does scale, though it lacks a rate.) Highest "
      "is the height of the highest pup's centre after step 500, in radii.");
  std::vector<Params> settings;
  const std::vector<double> scales =
      options.quick ? std::vector{1.0, 10.0} : std::vector{0.1, 0.5, 1.0, 2.0, 10.0};
  const std::vector<double> temperatures =
      options.quick ? std::vector{0.2} : std::vector{0.2, 0.5, 0.8};
  Params base;
  for (const double ta : temperatures) {
    for (const double scale : scales) {
      base.ambient_temperature = ta;
      settings.push_back(in_unit(base, scale));
    }
  }
  const auto means =
      means_of_runs("units", settings, options.quick ? 2 : 10, options, measure_scaled);
  io::CsvFile csv =
      report.csv("units", Params{}, "ta,factor" + statistic_columns() + ",highest,highest_se");
  std::vector<io::Row> rows{{"T_a", "factor"}};
  add_statistic_labels(rows[0]);
  rows[0].emplace_back("highest");
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const double scale = scales[i % scales.size()];
    csv.cell(settings[i].ambient_temperature).cell(scale);
    rows.push_back({rounded(settings[i].ambient_temperature), rounded(scale)});
    end_row(means[i], csv, rows);
  }
  csv.commit();
  report.table(rows);
  base.ambient_temperature = 0.2;
  const Parting parting = part_by_unit(base, 10, 1500);
  report.text("Seed 1 at T_a = 0.2 with factor 10: the first contact is in step " +
              std::to_string(parting.contact) +
              ", and the centres are first more than 10⁻⁶ apart (in the first unit) in step " +
              std::to_string(parting.step) + ".");
}

}  // namespace pupflow::report
