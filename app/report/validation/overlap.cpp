// How far bodies overlap, with each reading of the contact rule.
#include "pupflow/overlap.h"
#include "app/report/validation/readings.h"
#include "app/report/validation/sections.h"

namespace pupflow::report {
namespace {

/// Means over looks 25 steps apart after `discard`: distance to the nearest centre, the least one,
/// share of points inside another body, share of those that touch no other pup.
std::vector<double> measure_bodies(const Params& params) {
  Simulation simulation(params);
  OverlapMeter meter;
  OverlapMeans means;
  while (simulation.steps_done() < params.steps) {
    step_on(simulation);
    if (simulation.steps_done() <= params.discard || simulation.steps_done() % 25 != 0) continue;
    means.add(meter.measure(simulation));
  }
  const Overlap o = means.means();
  return {o.nearest, o.least, o.inside, o.inside_exposed};
}

}  // namespace

void overlap_section(Report& report) {
  const Options& options = report.options();
  report.heading("Interpenetration");
  report.text(
      "Contacts move points by a share of their overlap only, so bodies overlap. "
      "Nearest is the distance from a pup's centre to the nearest other one, mean over pups; two "
      "round pups that touch are 2 (r_pup + r_point) = 0.6 apart at most. Least is the smallest "
      "of these distances in the run. Inside is the share of all points that lie inside another "
      "body. Exposed is the share of these that touch no point of another pup and so count as "
      "exposed to the air. Every 25th step from 501 to 1500.");
  std::vector<Params> settings;
  const std::vector<double> ta =
      options.quick ? std::vector{0.2, 0.8} : std::vector{0.0, 0.2, 0.4, 0.5, 0.6, 0.8};
  for (const Reading& reading : kReadings) {
    for (const double t : ta) {
      settings.emplace_back();
      settings.back().ambient_temperature = t;
      settings.back().contact = reading.rule;
    }
  }
  const auto means =
      means_of_runs("overlap", settings, options.quick ? 1 : 5, options, measure_bodies);
  io::CsvFile csv =
      report.csv("overlap", Params{},
                 "contact,ta,nearest,nearest_se,least,least_se,inside,inside_se,inside_exposed,"
                 "inside_exposed_se");
  std::vector<io::Row> rows{{"contact", "T_a", "nearest", "least", "inside", "exposed"}};
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const std::string reading = kReadings[static_cast<std::size_t>(settings[i].contact)].name;
    csv.cell(std::string_view(reading)).cell(settings[i].ambient_temperature);
    rows.push_back({reading, rounded(settings[i].ambient_temperature)});
    end_row(means[i], csv, rows);
  }
  csv.commit();
  report.table(rows);
}

}  // namespace pupflow::report
