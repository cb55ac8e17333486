// The page of a measured scene.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "app/io/text_stream.h"
#include "app/report/error/scene.h"

namespace pupflow::report {
namespace {

/// Colors that color-blind readers can tell apart (Okabe & Ito 2008).
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

std::string columns_of(const ErrorScene& scene) {
  std::string columns = "method,setting,dt,seconds";
  for (const Quantity& q : scene.quantities) columns += ",error_" + q.name;
  for (const Quantity& q : scene.quantities) columns += ",order_" + q.name;
  return columns;
}

std::string cell_of(const Measured& point, std::size_t q) {
  if (!point.status.ok()) return "step " + std::to_string(point.status.step) + ": failed";
  if (!std::isfinite(point.errors[q])) return "not finite";
  std::string text = rounded(point.errors[q], 2);
  if (std::isfinite(point.orders[q])) text += " (" + rounded(point.orders[q], 2) + ")";
  return text;
}

/// A table of some quantities, a row at a time.
class Table {
 public:
  Table(const ErrorScene& scene, io::Row head, std::vector<std::size_t> quantities)
      : quantities_(std::move(quantities)) {
    head.emplace_back("ms per model second");
    for (const std::size_t q : quantities_) {
      head.push_back("error of " + scene.quantities[q].title);
    }
    rows_.push_back(std::move(head));
  }

  void add(io::Row row, const Measured& point) {
    row.push_back(rounded(1e3 * point.seconds));
    for (const std::size_t q : quantities_) row.push_back(cell_of(point, q));
    rows_.push_back(std::move(row));
  }

  const std::vector<io::Row>& rows() const { return rows_; }

 private:
  std::vector<std::size_t> quantities_;
  std::vector<io::Row> rows_;
};

/// Plots the rows of one file for which `condition` is true. Errors below the plot's lower edge are
/// drawn on it as triangles that point down: upper bounds.
std::string points_text(const ErrorScene& scene, const std::string& file,
                        const std::string& condition, const Quantity& quantity,
                        const std::string& style, const std::string& color,
                        const std::string& title) {
  io::TextStream s;
  const std::string error = "column('error_" + quantity.name + "')";
  const std::string pick = "'" + file + "' using (" + condition + " && " + error;
  s << pick << " >= " << scene.smallest_drawn << " ? column('seconds') : NaN):(" << error
    << ") with " << style << " lc '" << color << "' title '" << title << "', \\\n       " << pick
    << " < " << scene.smallest_drawn << " ? column('seconds') : NaN):(" << scene.smallest_drawn
    << ") with points pt 11 ps 1 lc '" << color << "' notitle";
  return s.str();
}

/// A line of slope -1, a little below the finest point of the first curve that refines.
std::string guide_text(const SceneResult& result, std::size_t q) {
  for (const MeasuredCurve& curve : result.curves) {
    if (!curve.refines) continue;
    const Measured *first = nullptr, *last = nullptr;
    for (const Measured& point : curve.points) {
      if (!point.status.ok() || !(point.errors[q] > 0) || !std::isfinite(point.errors[q])) continue;
      if (first == nullptr) first = &point;
      last = &point;
    }
    if (last == nullptr || first == last) continue;
    io::TextStream s;
    s << ", \\\n       (x >= " << first->seconds << " && x <= " << last->seconds << " ? "
      << 0.6 * last->errors[q] * last->seconds
      << " / x : NaN) with lines lw 1 dt 2 lc '#888888' title 'slope -1: twice the time, half the "
         "error'";
    return s.str();
  }
  return "";
}

/// The key's entry for what is below the lower edge, where there is any.
std::string bound_key(const ErrorScene& scene, const std::vector<Measured>& points,
                      const std::vector<std::size_t>& quantities) {
  for (const Measured& point : points) {
    for (const std::size_t q : quantities) {
      if (point.errors[q] < scene.smallest_drawn) {
        return ", \\\n       NaN with points pt 11 lc '#444444' title 'below the lower edge'";
      }
    }
  }
  return "";
}

std::string panels_head(const ErrorScene& scene, std::size_t panels, int width) {
  io::TextStream s;
  s << "  set yrange [" << scene.smallest_drawn
    << ":*]\n  set logscale xy\n  set format '10^{%L}'\n  set xlabel 'time on one core, s per "
       "model "
       "second'\n"
    << "  set grid lt 1 lc rgb '#dddddd'\n  set multiplot layout 1," << panels << " margins "
    << 95.0 / width << ",0.97,0.4,0.92 spacing " << 115.0 / width << ",0\n";
  return s.str();
}

std::string panel_head(const Quantity& quantity, bool first, int rows) {
  return "  set title \"error of " + quantity.title + "\"\n  " +
         (first ? "set key at screen 0.02, screen 0.02 left bottom maxrows " +
                      std::to_string(rows) + " Left reverse"
                : "unset key") +
         "\n  plot ";
}

constexpr int panels_width(std::size_t panels) {
  return std::max(900, 460 * static_cast<int>(panels) + 100);
}

std::vector<std::size_t> drawn_quantities(const ErrorScene& scene) {
  std::vector<std::size_t> drawn;
  for (std::size_t q = 0; q < scene.quantities.size(); ++q) {
    if (scene.quantities[q].drawn) drawn.push_back(q);
  }
  return drawn;
}

/// One panel for each quantity that is drawn, one line for each curve.
std::string plot_of(const ErrorScene& scene, const SceneResult& result, int width) {
  const std::string file = scene.name + ".csv";
  const auto method = [](const std::string& name) { return "strcol('method') eq '" + name + "'"; };
  const std::vector<std::size_t> drawn = drawn_quantities(scene);
  std::vector<Measured> all;
  for (const MeasuredCurve& curve : result.curves) {
    all.insert(all.end(), curve.points.begin(), curve.points.end());
  }
  const std::string bound = bound_key(scene, all, drawn);
  std::string text = panels_head(scene, drawn.size(), width);
  for (const std::size_t q : drawn) {
    const Quantity& quantity = scene.quantities[q];
    text += panel_head(quantity, q == drawn.front(), 4);
    for (std::size_t c = 0; c < result.curves.size(); ++c) {
      const std::string& name = result.curves[c].name;
      text += (c == 0 ? "" : ", \\\n       ") + points_text(scene, file, method(name), quantity,
                                                            "linespoints lw 1.6 pt 7 ps 0.6",
                                                            kColors[c % std::size(kColors)], name);
    }
    if (!scene.standard_is_exact) {
      text += ", \\\n       " + points_text(scene, file, method("default"), quantity,
                                            "points pt 6 ps 2.2 lw 2", "#000000", "default");
    }
    text += guide_text(result, q) + bound + "\n";
  }
  return text + "  unset multiplot\n";
}

std::string reference_words(const ErrorScene& scene, const SceneResult& result) {
  std::string changes, differences;
  for (std::size_t q = 0; q < scene.quantities.size(); ++q) {
    if (result.reference_difference[q] == 0) continue;  // a closed form
    const std::string of = " (" + scene.quantities[q].title + ")";
    const std::string comma = changes.empty() ? "" : ", ";
    changes += comma + rounded(100 * result.reference_change[q], 2) + " %" + of;
    differences += comma + rounded(result.reference_difference[q], 2) + of;
  }
  const std::string text = "Reference: " + scene.reference.label + ".";
  if (changes.empty()) return text;
  return text + " A run with twice its step differs from it by " + differences +
         ", measured as an error. With that run as the reference the errors of the default and of "
         "all refining settings change by at most " +
         changes + ".";
}

/// Below this an error is rounding.
constexpr double kRounding = 1e-9;

double largest_error(const Aside& aside, const std::vector<Measured>& points) {
  double largest = 0;
  for (const Measured& point : points) {
    for (const std::size_t q : aside.quantities) {
      if (!std::isfinite(point.errors[q])) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, point.errors[q]);
    }
  }
  return largest;
}

std::string aside_plot(const ErrorScene& scene, const Aside& aside,
                       const std::vector<Measured>& points, const std::string& file, int width) {
  std::string text = panels_head(scene, aside.quantities.size(), width);
  for (const std::size_t q : aside.quantities) {
    text += panel_head(scene.quantities[q], q == aside.quantities.front(), 4);
    for (std::size_t i = 0; i < aside.settings.size(); ++i) {
      std::string title = aside.settings[i].label;
      for (std::size_t at = 0; (at = title.find('\'', at)) != std::string::npos; at += 2) {
        title.insert(at, "'");
      }
      text += (i == 0 ? "" : ", \\\n       ") +
              points_text(scene, file, "$0 == " + std::to_string(i), scene.quantities[q],
                          "points pt 7 ps 1.2", kColors[i % std::size(kColors)], title);
    }
    text += bound_key(scene, points, aside.quantities) + "\n";
  }
  return text + "  unset multiplot\n";
}

void show_aside(Report& report, const ErrorScene& scene, const Aside& aside,
                const std::vector<Measured>& points) {
  report.subheading(aside.title);
  report.text(aside.about);
  const double largest = largest_error(aside, points);
  if (largest < kRounding) {
    report.text("All are within " + rounded(largest, 2) +
                " of the reference in every quantity, so the choice does not matter.");
    return;
  }
  const std::string name = scene.name + "-" + aside.name;
  io::CsvFile csv = report.csv(name, aside.reference.params, columns_of(scene));
  Table table(scene, {"setting"}, aside.quantities);
  for (const Measured& point : points) {
    write_row(csv, aside.name, point);
    table.add({point.setting.label}, point);
  }
  csv.commit();
  const int width = panels_width(aside.quantities.size());
  report.figure(name,
                scene.title + ", " + aside.title +
                    ": error against run time, both logarithmic; a triangle on the lower edge is "
                    "an error below that edge",
                aside_plot(scene, aside, points, name + ".csv", width), aside.reference.params,
                width, 540);
  report.table(table.rows());
}

}  // namespace

void show(Report& report, const ErrorScene& scene, const SceneResult& result) {
  report.heading(scene.title);
  report.text(scene.about);
  report.text(reference_words(scene, result));
  std::vector<std::size_t> all(scene.quantities.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  io::CsvFile csv = report.csv(scene.name, scene.standard.params, columns_of(scene));
  Table table(scene, {"method", "setting"}, all);
  const auto add = [&](const std::string& name, const std::string& shown, const Measured& point) {
    write_row(csv, name, point);
    table.add({shown, point.setting.label}, point);
  };
  if (!scene.standard_is_exact) add("default", "**default**", result.standard);
  for (const MeasuredCurve& curve : result.curves) {
    for (const Measured& point : curve.points) add(curve.name, curve.name, point);
  }
  csv.commit();
  const int width = panels_width(drawn_quantities(scene).size());
  report.figure(scene.name,
                scene.title +
                    ": error against run time, both logarithmic; a triangle on the lower edge is "
                    "an error below that edge",
                plot_of(scene, result, width), scene.standard.params, width, 540);
  report.table(table.rows());
  for (std::size_t i = 0; i < scene.asides.size(); ++i) {
    show_aside(report, scene, scene.asides[i], result.asides[i]);
  }
}

}  // namespace pupflow::report
