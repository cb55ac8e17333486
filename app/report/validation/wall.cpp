// Where the pups are after long runs: nothing slows or turns a pup without contact.
#include <cmath>

#include "app/report/validation/runs.h"
#include "app/report/validation/sections.h"

namespace pupflow::report {
namespace {

constexpr double kNear = 1.6;

std::vector<std::int64_t> looks(bool quick) {
  if (quick) return {0, 500, 1500, 3000};
  return {0, 500, 1500, 3000, 6000, 12000};
}

/// At each look the share of pups beyond kNear, over the 100 steps up to it.
std::vector<double> measure_places(const Params& params, const std::vector<std::int64_t>& looks) {
  Simulation simulation(params);
  std::vector<double> shares;
  double beyond = 0, steps = 0;
  for (const std::int64_t look : looks) {
    beyond = steps = 0;
    do {
      if (look > 0) step_on(simulation);
      if (simulation.steps_done() + 100 <= look) continue;
      ++steps;
      for (int pup = 0; pup < params.pups; ++pup) {
        const Eigen::Vector3d centre = simulation.view().positions.mean(pup);
        beyond += std::hypot(centre.x(), centre.y()) > kNear ? 1 : 0;
      }
    } while (simulation.steps_done() < look);
    shares.push_back(beyond / (steps * params.pups));
  }
  return shares;
}

}  // namespace

void wall_section(Report& report) {
  const Options& options = report.options();
  const std::vector<std::int64_t> at = looks(options.quick);
  report.heading("Positions in long runs");
  report.text(
      "A pup without contact feels the same temperature left and right, so it keeps its course, "
      "and no friction slows it: it moves to the wall and stays there until another pup touches "
      "it. The table shows the share of pups whose centre is more than 1.6 from the middle of the "
      "arena, whose radius is 2; a pup at the wall is at about 1.7. Each row is the mean over the "
      "100 steps up to its step.");
  std::vector<Params> settings;
  std::vector<io::Row> rows{{"step"}};
  for (const double ta : {0.2, 0.5, 0.6, 0.8}) {
    settings.emplace_back();
    settings.back().ambient_temperature = ta;
    rows[0].push_back("T_a = " + rounded(ta));
  }
  settings.emplace_back();
  settings.back().pups = 1;
  rows[0].emplace_back("one pup alone");
  const auto means = means_of_runs("places", settings, options.quick ? 2 : 6, options,
                                   [&](const Params& p) { return measure_places(p, at); });
  io::CsvFile csv = report.csv("wall", Params{}, "pups,ta,step,beyond,beyond_se");
  for (std::size_t look = 0; look < at.size(); ++look) {
    rows.push_back({std::to_string(at[look])});
    for (std::size_t i = 0; i < settings.size(); ++i) {
      const MeanAndError& share = means[i][look];
      rows.back().push_back(text_of(share));
      csv.cell(std::int64_t{settings[i].pups}).cell(settings[i].ambient_temperature).cell(at[look]);
      csv.cell(share.mean).cell(share.error).end_row();
    }
  }
  csv.commit();
  report.table(rows);
}

}  // namespace pupflow::report
