#include "app/report/validation/flow.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/io/gnuplot.h"
#include "app/report/validation/runs.h"
#include "app/report/validation/sections.h"

namespace pupflow::report {
namespace {

constexpr std::size_t kHistory = 101;  // the longest lag, and the step now
static_assert(kLags[std::size(kLags) - 1] == kHistory - 1);

}  // namespace

std::vector<double> measure_flow(const Params& params) {
  Simulation simulation(params);
  std::vector<std::vector<double>> history(kHistory);  // of A, step s at s % kHistory
  const auto at = [&](std::int64_t step) -> std::vector<double>& {
    return history[static_cast<std::size_t>(step) % kHistory];
  };
  std::vector<double> flow(std::size(kLags));
  double counted = 0, changed = 0, by_one = 0;
  const double points = simulation.points();
  at(0).assign(simulation.view().exposed.begin(), simulation.view().exposed.end());
  while (simulation.steps_done() < params.steps) {
    step_on(simulation);
    const std::int64_t now = simulation.steps_done();
    at(now).assign(simulation.view().exposed.begin(), simulation.view().exposed.end());
    if (now <= std::max<std::int64_t>(params.discard, kHistory - 1)) continue;
    for (std::size_t pup = 0; pup < at(now).size(); ++pup) {
      ++counted;
      for (std::size_t i = 0; i < std::size(kLags); ++i) {
        const double change = std::abs(at(now)[pup] - at(now - kLags[i])[pup]);
        flow[i] += change / (static_cast<double>(kLags[i]) * params.dt);
        const auto moved = static_cast<int>(std::lround(change * points));
        if (kLags[i] != 1 || moved == 0) continue;
        ++changed;
        by_one += moved == 1 ? 1 : 0;
      }
    }
  }
  for (double& sum : flow) sum /= counted;
  flow.push_back(changed > 0 ? by_one / changed : 0);
  flow.push_back(1 - changed / counted);
  return flow;
}

void flow_section(Report& report) {
  const Options& options = report.options();
  report.heading("Pup flow over several lags");
  Params base;
  base.ambient_temperature = 0.4;
  report.text(
      "Flow over a lag is the mean of |A(t) − A(t − lag)| / lag, per second. One point that "
      "begins or ceases to touch between two steps makes a flow of 1/(" +
      std::to_string(points_per_pup(base)) +
      " · 0.01 s) = " + rounded(1 / (points_per_pup(base) * base.dt), 2) +
      " per second for that pup and step. A lasting change gives the same flow over every lag up "
      "to "
      "its duration; flow that falls with the lag comes from changes that reverse. The last two "
      "columns are the share of changes of A that are one point, and the share of steps in which "
      "A did not change.");
  std::vector<Params> settings;
  for (const double ta : options.quick ? std::vector{0.2, 0.5, 0.8} : spaced(0, 1, 21)) {
    settings.push_back(base);
    settings.back().ambient_temperature = ta;
  }
  const auto means = means_of_runs("flow", settings, options.quick ? 2 : 8, options, measure_flow);
  std::string columns = "ta";
  std::vector<io::Row> rows{{"T_a"}};
  for (const std::int64_t lag : kLags) {
    const std::string name = std::to_string(lag);
    columns += ",flow_" + name + ",flow_" + name + "_se";
    rows[0].push_back("lag " + name);
  }
  rows[0].insert(rows[0].end(), {"one point", "no change"});
  io::CsvFile csv = report.csv("flow", base, columns + ",one_point,one_point_se,still,still_se");
  for (std::size_t i = 0; i < settings.size(); ++i) {
    csv.cell(settings[i].ambient_temperature);
    rows.push_back({rounded(settings[i].ambient_temperature)});
    end_row(means[i], csv, rows);
  }
  csv.commit();
  report.table(rows);
  std::string plots;
  const char* const colors[] = {"#0072B2", "#009E73", "#E69F00", "#D55E00"};
  for (std::size_t i = 0; i < std::size(kLags); ++i) {
    const std::string name = "flow_" + std::to_string(kLags[i]);
    plots += (i > 0 ? ", \\\n       " : "") + ("'flow.csv' using 'ta':'" + name) + "':(2*column('" +
             name + "_se')) with yerrorlines pt 7 ps 0.6 lw 1.6 lc '" + colors[i] +
             "' title 'lag " + std::to_string(kLags[i]) + "'";
  }
  report.figure("flow", "Pup flow over four lags, in steps; bars are two standard errors",
                "  set border 7\n" + io::celsius_axis("x", 0, 1) +
                    "  set xlabel 'ambient temperature T_a'\n  set ylabel 'pup flow (1/s)'\n"
                    "  set yrange [0:*]\n  set grid lc '#dddddd'\n  set key top left Left reverse\n"
                    "  plot " +
                    plots + "\n",
                base);
}

}  // namespace pupflow::report
