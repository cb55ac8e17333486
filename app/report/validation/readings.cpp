// Several contacts of one point: the three readings (ContactRule) side by side.
#include <algorithm>
#include <cmath>

#include "app/io/gnuplot.h"
#include "app/report/statistics.h"
#include "app/report/validation/readings.h"
#include "app/report/validation/sections.h"
#include "pupflow/ensemble.h"

namespace pupflow::report {
namespace {

constexpr std::size_t kTb = statistic_of(Observable::mean_tb),
                      kHuddling = statistic_of(Observable::huddling),
                      kGroups = statistic_of(Observable::groups),
                      kLargest = statistic_of(Observable::largest),
                      kFlow = statistic_of(Observable::flow);

ReadingCurve curve_of(const std::string& reading, const std::vector<double>& ta,
                      const std::vector<std::vector<MeanAndError>>& means) {
  ReadingCurve curve{reading, ta, {}, {}, {}};
  const Params defaults;
  for (std::size_t i = 0; i < ta.size(); ++i) {
    curve.means.push_back(means[i]);
    const std::size_t low = i > 0 ? i - 1 : i, high = std::min(i + 1, ta.size() - 1);
    curve.slope.push_back(std::abs(means[high][kHuddling].mean - means[low][kHuddling].mean) /
                          (ta[high] - ta[low]));
    curve.held.push_back(defaults.preferred_temperature -
                         defaults.thermogenesis /
                             (defaults.air_conductance * (1 - means[i][kHuddling].mean)));
  }
  return curve;
}

void write_csv(const Report& report, const std::string& name, const Params& params,
               const std::vector<ReadingCurve>& curves) {
  io::CsvFile csv =
      report.csv(name, params, "reading,ta" + statistic_columns() + ",slope,ta_star,tb_above_ta");
  for (const ReadingCurve& curve : curves) {
    for (std::size_t i = 0; i < curve.ta.size(); ++i) {
      csv.cell(std::string_view(curve.reading)).cell(curve.ta[i]);
      for (const MeanAndError& number : curve.means[i]) csv.cell(number.mean).cell(number.error);
      csv.cell(curve.slope[i]).cell(curve.held[i]).cell(curve.means[i][kTb].mean - curve.ta[i]);
      csv.end_row();
    }
  }
  csv.commit();
}

void curve_table(Report& report, const ReadingCurve& curve) {
  report.subheading("contact = " + curve.reading);
  std::vector<io::Row> rows{{"T_a"}};
  add_statistic_labels(rows[0]);
  rows[0].insert(rows[0].end(), {"\\|dA/dT_a\\|", "T_a*"});
  for (std::size_t i = 0; i < curve.ta.size(); ++i) {
    rows.push_back({rounded(curve.ta[i])});
    for (const MeanAndError& number : curve.means[i]) rows.back().push_back(text_of(number));
    rows.back().push_back(rounded(curve.slope[i], 2));
    rows.back().push_back(rounded(curve.held[i]));
  }
  report.table(rows);
}

std::string range_text(double low, double high, int digits = 3) {
  return rounded(low, digits) + " … " + rounded(high, digits);
}

/// The lowest and highest mean of statistic `n` where `in` is true of T_a.
template <class In>
std::string extent(const ReadingCurve& curve, std::size_t n, In in) {
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = 0; i < curve.ta.size(); ++i) {
    if (!in(curve.ta[i])) continue;
    low = std::min(low, curve.means[i][n].mean);
    high = std::max(high, curve.means[i][n].mean);
  }
  return range_text(low, high);
}

bool cold(double ta) {
  return ta < 0.41;
}
bool warm(double ta) {
  return ta > 0.6;
}

/// The temperatures whose mean T_b lies within 0.03 of T_p, among those of the sweep.
std::string regulated(const ReadingCurve& curve) {
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = 0; i < curve.ta.size(); ++i) {
    if (std::abs(curve.means[i][kTb].mean - Params{}.preferred_temperature) > 0.03) continue;
    low = std::min(low, curve.ta[i]);
    high = std::max(high, curve.ta[i]);
  }
  return low > high ? "nowhere" : range_text(low, high, 2);
}

std::string highest(const ReadingCurve& curve, std::size_t n) {
  std::size_t top = 0;
  for (std::size_t i = 0; i < curve.ta.size(); ++i) {
    if (curve.means[i][n].mean > curve.means[top][n].mean) top = i;
  }
  return rounded(curve.means[top][n].mean) + " at " + rounded(curve.ta[top], 2);
}

std::string peak_text(const ReadingCurve& curve, std::size_t n) {
  const Peak peak = peak_of(curve, n);
  return rounded(peak.height) + " at " + rounded(peak.ta, 2) + ", by " + rounded(peak.above, 2);
}

std::string steepest(const ReadingCurve& curve) {
  const auto at = std::max_element(curve.slope.begin(), curve.slope.end()) - curve.slope.begin();
  return rounded(curve.slope[static_cast<std::size_t>(at)], 2) + " at " +
         rounded(curve.ta[static_cast<std::size_t>(at)], 2);
}

double mean_held_in_the_cold(const ReadingCurve& curve) {
  double huddling = 0;
  int count = 0;
  for (std::size_t i = 0; i < curve.ta.size(); ++i) {
    if (!cold(curve.ta[i])) continue;
    huddling += curve.means[i][kHuddling].mean;
    ++count;
  }
  const Params defaults;
  return defaults.preferred_temperature -
         defaults.thermogenesis / (defaults.air_conductance * (1 - huddling / count));
}

void summary_table(Report& report, const std::vector<ReadingCurve>& curves) {
  std::vector<io::Row> rows{{""}};
  for (const ReadingCurve& curve : curves) rows[0].push_back(curve.reading);
  const auto row = [&](const std::string& title, const auto& cell) {
    rows.push_back({title});
    for (const ReadingCurve& curve : curves) rows.back().push_back(cell(curve));
  };
  row("T_b − T_a at the lowest T_a",
      [](const ReadingCurve& c) { return rounded(c.means[0][kTb].mean - c.ta[0]); });
  row("1 − A, cold", [](const ReadingCurve& c) { return extent(c, kHuddling, cold); });
  row("1 − A, warm", [](const ReadingCurve& c) { return extent(c, kHuddling, warm); });
  row("T_a* from the mean A of the cold",
      [](const ReadingCurve& c) { return rounded(mean_held_in_the_cold(c), 2); });
  row("T_a at which mean T_b is within 0.03 of T_p", regulated);
  row("steepest \\|dA/dT_a\\|", steepest);
  row("groups, cold", [](const ReadingCurve& c) { return extent(c, kGroups, cold); });
  row("groups, warm", [](const ReadingCurve& c) { return extent(c, kGroups, warm); });
  row("largest group, cold", [](const ReadingCurve& c) { return extent(c, kLargest, cold); });
  row("largest group, warm", [](const ReadingCurve& c) { return extent(c, kLargest, warm); });
  for (const auto& [title, n] : {std::pair{"flow, lag 1", kFlow}, {"sd of A", kExposedSd}}) {
    row(std::string(title) + ": highest", [n = n](const ReadingCurve& c) { return highest(c, n); });
    row(std::string(title) + ": highest from 0.3 to 0.6, by how much",
        [n = n](const ReadingCurve& c) { return peak_text(c, n); });
  }
  report.table(rows);
}

void add_figure(Report& report, const std::string& name, const Params& params) {
  struct Panel {
    std::string title, column, error;
  };
  std::vector<Panel> panels{
      {"mean T_b − T_a", "tb_above_ta", statistic_name(Observable::mean_tb) + "_se"}};
  for (const std::size_t n : {kHuddling, kGroups, kExposedSd}) {
    const Field& field = run_statistics()[n];
    const std::string column(field.name);
    panels.push_back({std::string(field.label), column, column + "_se"});
  }
  constexpr const char* kColors[] = {"#0072B2", "#E69F00", "#444444"};
  std::string body =
      "  set multiplot layout 2,2 margins 0.09,0.975,0.1,0.92 spacing 0.11,0.18\n"
      "  set border 7\n" +
      io::celsius_axis("x", 0, 1) +
      "  set xlabel 'ambient temperature T_a'\n  set xrange [0:1]\n  set yrange [0:*]\n"
      "  set grid lc '#dddddd'\n";
  bool first = true;
  for (const Panel& panel : panels) {
    body += "  set title '" + panel.title + "'\n";
    body += first ? "  set key top right Left reverse samplen 2\n" : "  unset key\n";
    body += "  plot ";
    for (std::size_t rule = 0; rule < std::size(kReadings); ++rule) {
      const std::string reading = kReadings[rule].name;
      const std::string own = "(strcol('reading') eq '" + reading + "' ? column('ta') : NaN)";
      const std::string look = " lc '" + std::string(kColors[rule]) + "' ";
      body += (rule > 0 ? ", \\\n       " : "") + ("'" + name + ".csv' using " + own + ":'") +
              panel.column + "':(2*column('" + panel.error + "')) with yerrorbars pt 7 ps 0.5" +
              look + "notitle, '' using " + own + ":'" + panel.column + "' with lines lw 1.6" +
              look + "title '" + reading + "'";
    }
    body += "\n";
    first = false;
  }
  report.figure(name, "The three readings over ambient temperature; bars are two standard errors",
                body + "  unset multiplot\n", params, 980, 760);
}

void show_heading(Report& report, Heading heading, int temperatures, int seeds) {
  const Options& options = report.options();
  const bool course = heading == Heading::course;
  const std::string name = course ? "readings" : "readings_body";
  const std::vector<double> ta = spaced(0, 1, temperatures);
  Params base;
  base.heading = heading;
  std::vector<Params> settings;
  for (const Reading& reading : kReadings) {
    for (const double t : ta) {
      settings.push_back(base);
      settings.back().ambient_temperature = t;
      settings.back().contact = reading.rule;
    }
  }
  const auto means = means_of_runs(name, settings, seeds, options, measure_reading);
  std::vector<ReadingCurve> curves;
  for (std::size_t i = 0; i < std::size(kReadings); ++i) {
    const auto begin = means.begin() + static_cast<std::ptrdiff_t>(i * ta.size());
    curves.push_back(
        curve_of(kReadings[i].name, ta, {begin, begin + static_cast<std::ptrdiff_t>(ta.size())}));
  }
  report.heading(course ? "The three contact readings" : "The three readings with heading = body");
  report.text(std::to_string(temperatures) + " temperatures, " + std::to_string(seeds) +
              " litters at each, steps 501 to 1500, as in the paper's Figure 2.");
  write_csv(report, name, base, curves);
  add_figure(report, name, base);
  report.text(
      "Cold is T_a below 0.41, warm is T_a above 0.6; \"0.4 … 0.6\" are the lowest and the "
      "highest of the means. T_a* = T_p − G/(k₁ A) is the ambient temperature at which T_b = T_p "
      "is the equilibrium of a pup with that A. \"By\" is how far the highest mean is above the "
      "means at lower T_a and above those at higher T_a, in standard errors of the difference: the "
      "largest value on each side, then the smaller of the two. Below 3 it is no peak.");
  summary_table(report, curves);
  for (const ReadingCurve& curve : curves) curve_table(report, curve);
}

}  // namespace

std::vector<double> measure_reading(const Params& params) {
  Simulation simulation(params);
  RunMeans means(params.discard);
  while (simulation.steps_done() < params.discard) step_on(simulation);
  Observer observer(simulation);
  while (simulation.steps_done() < params.steps) {
    step_on(simulation);
    means.add(simulation, observer.observe(simulation));
  }
  return statistics_of(means);
}

Peak peak_of(const ReadingCurve& curve, std::size_t statistic) {
  const auto mean = [&](std::size_t i) { return curve.means[i][statistic].mean; };
  std::size_t top = curve.ta.size();
  for (std::size_t i = 0; i < curve.ta.size(); ++i) {
    if (curve.ta[i] < 0.3 || curve.ta[i] > 0.6) continue;
    if (top == curve.ta.size() || mean(i) > mean(top)) top = i;
  }
  const auto most_above = [&](std::size_t begin, std::size_t end) {
    double most = 0;
    for (std::size_t i = begin; i < end; ++i) {
      most = std::max(most, (mean(top) - mean(i)) / std::hypot(curve.means[top][statistic].error,
                                                               curve.means[i][statistic].error));
    }
    return most;
  };
  return {curve.ta[top], mean(top),
          std::min(most_above(0, top), most_above(top + 1, curve.ta.size()))};
}

void readings_section(Report& report) {
  const bool quick = report.options().quick;
  show_heading(report, Heading::course, quick ? 5 : 24, quick ? 2 : 20);
}

void body_section(Report& report) {
  const bool quick = report.options().quick;
  show_heading(report, Heading::body, quick ? 3 : 13, quick ? 1 : 6);
}

}  // namespace pupflow::report
