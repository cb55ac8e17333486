// How a measured scene looks on the page.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/report/scene.h"

namespace pupflow::report {
namespace {

/// Colours that colour-blind readers can tell apart (Okabe & Ito 2008).
constexpr const char* kColors[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                   "#E69F00", "#56B4E9", "#444444", "#B8A800"};

void write_row(io::CsvFile& csv, const std::string& curve, const Measured& point) {
  std::string label = point.setting.label;
  std::replace(label.begin(), label.end(), ',', ';');
  csv.cell(std::string_view(curve)).cell(std::string_view(label));
  csv.cell(point.setting.params.dt).cell(point.seconds);
  for (const double error : point.errors) csv.cell(error);
  for (const double order : point.orders) csv.cell(order);
  csv.end_row();
}

void write_csv(const Report& report, const Scene& scene, const SceneResult& result) {
  std::string columns = "method,setting,dt,seconds";
  for (const Quantity& q : scene.quantities) columns += ",error_" + q.name;
  for (const Quantity& q : scene.quantities) columns += ",order_" + q.name;
  io::CsvFile csv = report.csv(scene.name, scene.standard.params, columns);
  write_row(csv, "default", result.standard);
  for (const MeasuredCurve& curve : result.curves) {
    for (const Measured& point : curve.points) write_row(csv, curve.name, point);
  }
  csv.commit();
}

std::string cell_of(const Measured& point, std::size_t q) {
  if (!point.status.ok()) return "step " + std::to_string(point.status.step) + ": lost";
  if (!std::isfinite(point.errors[q])) return "beyond numbers";
  std::string text = rounded(point.errors[q], 2);
  if (std::isfinite(point.orders[q])) text += " (" + rounded(point.orders[q], 2) + ")";
  return text;
}

void add_table(Report& report, const Scene& scene, const SceneResult& result) {
  std::vector<io::Row> rows{{"method", "setting", "ms a model second"}};
  for (const Quantity& q : scene.quantities) rows[0].push_back("error of " + q.title);
  const auto add = [&](const std::string& name, const Measured& point) {
    io::Row row{name, point.setting.label, rounded(1e3 * point.seconds)};
    for (std::size_t q = 0; q < scene.quantities.size(); ++q) row.push_back(cell_of(point, q));
    rows.push_back(row);
  };
  add("**default**", result.standard);
  for (const MeasuredCurve& curve : result.curves) {
    for (const Measured& point : curve.points) add(curve.name, point);
  }
  report.table(rows);
}

/// One panel for each quantity, one line for each curve.
std::string plot_of(const Scene& scene, const SceneResult& result) {
  std::ostringstream s;
  const std::string file = "'" + scene.name + ".csv'";
  s << "  set yrange [" << scene.smallest_drawn
    << ":*]\n  set logscale xy\n  set format '10^{%L}'\n  set xlabel 'time on one core, s a model "
       "second'\n"
    << "  set grid lc '#dddddd'\n  set multiplot layout 1," << scene.quantities.size()
    << " margins 0.08,0.97,0.36,0.92 spacing 0.09,0\n";
  for (std::size_t q = 0; q < scene.quantities.size(); ++q) {
    const std::string error = "error_" + scene.quantities[q].name;
    s << "  set title \"error of " << scene.quantities[q].title << "\"\n  "
      << (q == 0 ? "set key at screen 0.02, screen 0.02 left bottom maxrows 4 Left reverse"
                 : "unset key")
      << "\n  plot ";
    const auto line = [&](const std::string& method, const std::string& style) {
      // What is too small to matter beside the rest is drawn at the lower edge.
      s << file << " using (strcol('method') eq '" << method
        << "' ? column('seconds') : NaN):(column('" << error << "') < " << scene.smallest_drawn
        << " ? " << scene.smallest_drawn << " : column('" << error << "')) with " << style;
    };
    for (std::size_t c = 0; c < result.curves.size(); ++c) {
      const std::string style = result.curves[c].ordered ? "linespoints lw 1.6" : "points";
      line(result.curves[c].name, style + " pt 7 ps 0.6 lc '" +
                                      std::string(kColors[c % std::size(kColors)]) + "' title '" +
                                      result.curves[c].name + "'");
      s << ", \\\n       ";
    }
    line("default", "points pt 6 ps 2.2 lw 2 lc '#000000' title 'default'");
    s << "\n";
  }
  s << "  unset multiplot\n";
  return s.str();
}

std::string reference_words(const Scene& scene, const SceneResult& result) {
  std::string changes;
  for (std::size_t q = 0; q < scene.quantities.size(); ++q) {
    if (result.reference_change[q] == 0) continue;  // a closed form
    changes += (changes.empty() ? "" : ", ") + rounded(100 * result.reference_change[q], 2) +
               " % (" + scene.quantities[q].title + ")";
  }
  const std::string text = "Right answer: " + scene.reference.label + ".";
  if (changes.empty()) return text;
  return text +
         " Halving its step changes the errors of the default and of all refining settings by at "
         "most " +
         changes + ".";
}

}  // namespace

void show(Report& report, const Scene& scene, const SceneResult& result) {
  report.heading(scene.title);
  report.text(scene.about);
  report.text(reference_words(scene, result));
  write_csv(report, scene, result);
  report.figure(scene.name,
                scene.title +
                    ": error against run time, both logarithmic; errors below the lower edge are "
                    "drawn on it",
                plot_of(scene, result), scene.standard.params,
                460 * static_cast<int>(scene.quantities.size()) + 100, 520);
  add_table(report, scene, result);
}

}  // namespace pupflow::report
