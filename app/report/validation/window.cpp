// How the means depend on their window: the paper's steps 501 to 1500, and later ones.
#include "app/io/gnuplot.h"
#include "app/report/statistics.h"
#include "app/report/validation/readings.h"
#include "app/report/validation/sections.h"
#include "pupflow/observer.h"

namespace pupflow::report {
namespace {

struct Window {
  const char* name;
  std::int64_t discard, steps;  // steps discard + 1 ... steps
};
constexpr Window kWindows[] = {
    {"501–1500", 500, 1500}, {"2501–4000", 2500, 4000}, {"3001–6000", 3000, 6000}};

/// The statistics of a run for each window that its `params.steps` steps cover, one window after the
/// other.
std::vector<double> measure_windows(const Params& params) {
  Simulation simulation(params);
  Observer observer(simulation);
  std::vector<RunMeans> means;
  for (const Window& window : kWindows) means.emplace_back(window.discard);
  std::vector<double> numbers;
  while (simulation.steps_done() < params.steps) {
    step_on(simulation);
    const Observables& now = observer.observe(simulation);
    for (std::size_t i = 0; i < std::size(kWindows); ++i) {
      if (simulation.steps_done() <= kWindows[i].steps) means[i].add(simulation, now);
      if (simulation.steps_done() != kWindows[i].steps) continue;
      const std::vector<double> own = statistics_of(means[i]);
      numbers.insert(numbers.end(), own.begin(), own.end());
    }
  }
  return numbers;
}

void show(Report& report, const std::string& name, const std::vector<Params>& settings,
          const std::vector<std::vector<MeanAndError>>& means) {
  io::CsvFile csv = report.csv(name, Params{}, "contact,ta,window" + statistic_columns());
  std::vector<io::Row> rows{{"contact", "T_a", "steps"}};
  add_statistic_labels(rows[0]);
  const auto reading = [&](std::size_t i) {
    return kReadings[static_cast<std::size_t>(settings[i].contact)].name;
  };
  const std::size_t windows = means[0].size() / kRunStatisticCount;
  // In the file the rows of a window are together, since a plot joins them; on the page those of
  // one T_a.
  for (std::size_t window = 0; window < windows; ++window) {
    for (std::size_t i = 0; i < settings.size(); ++i) {
      csv.cell(reading(i)).cell(settings[i].ambient_temperature).cell(kWindows[window].name);
      for (std::size_t n = 0; n < kRunStatisticCount; ++n) {
        const MeanAndError& number = means[i][window * kRunStatisticCount + n];
        csv.cell(number.mean).cell(number.error);
      }
      csv.end_row();
    }
  }
  for (std::size_t i = 0; i < settings.size(); ++i) {
    for (std::size_t window = 0; window < windows; ++window) {
      rows.push_back({reading(i), rounded(settings[i].ambient_temperature), kWindows[window].name});
      for (std::size_t n = 0; n < kRunStatisticCount; ++n) {
        rows.back().push_back(text_of(means[i][window * kRunStatisticCount + n]));
      }
    }
  }
  csv.commit();
  report.table(rows);
}

void add_figure(Report& report) {
  std::string body =
      "  set multiplot layout 1,3 margins 0.06,0.985,0.15,0.84 spacing 0.075,0\n"
      "  set border 7\n" +
      io::celsius_axis("x", 0.3, 0.65) +
      "  set xlabel 'ambient temperature T_a'\n  set xtics 0.1\n  set yrange [0:*]\n  set grid lc "
      "'#dddddd'\n";
  const std::size_t panels[] = {statistic_of(Observable::huddling), statistic_of(Observable::flow),
                                kExposedSd};
  for (const std::size_t panel : panels) {
    const std::string column(run_statistics()[panel].name);
    body += "  set title '" + std::string(run_statistics()[panel].label) + "'\n";
    body += panel == panels[0] ? "  set key bottom left Left reverse\n" : "  unset key\n";
    std::string plots;
    const char* const colors[] = {"#999999", "#0072B2"};
    for (std::size_t window = 0; window < 2; ++window) {
      const std::string name = kWindows[window].name;
      plots += (window > 0 ? ", \\\n       " : "") +
               ("'window.csv' using (strcol('window') eq '" + name + "' ? column('ta') : NaN):'") +
               column + "':(2*column('" + column +
               "_se')) with yerrorlines pt 7 ps 0.6 lw 1.6 lc '" + colors[window] +
               "' title 'steps " + name + "'";
    }
    body += "  plot " + plots + "\n";
  }
  report.figure("window", "The paper's window and a later one; bars are two standard errors",
                body + "  unset multiplot\n", Params{}, 1180, 400);
}

}  // namespace

void window_section(Report& report) {
  const Options& options = report.options();
  report.heading("The paper's window and later windows");
  report.text(
      "The same litters in the paper's window, steps 501 to 1500, and later. Where two rows "
      "differ by several standard errors, the litter was not yet stationary in the earlier one.");
  std::vector<Params> settings;
  for (const double ta : options.quick ? std::vector{0.4, 0.55} : spaced(0.3, 0.65, 15)) {
    settings.emplace_back();
    settings.back().ambient_temperature = ta;
    settings.back().steps = kWindows[1].steps;
  }
  show(report, "window", settings,
       means_of_runs("window", settings, options.quick ? 2 : 8, options, measure_windows));
  add_figure(report);
  report.text("Longer, with all readings:");
  settings.clear();
  for (const Reading& reading : kReadings) {
    for (const double ta :
         options.quick ? std::vector{0.55} : std::vector{0.2, 0.4, 0.5, 0.55, 0.6, 0.8}) {
      settings.emplace_back();
      settings.back().ambient_temperature = ta;
      settings.back().contact = reading.rule;
      settings.back().steps = kWindows[2].steps;
    }
  }
  show(report, "window_long", settings,
       means_of_runs("long window", settings, options.quick ? 1 : 4, options, measure_windows));
}

}  // namespace pupflow::report
