#include "app/report/stability/figure.h"

#include <algorithm>

#include "app/report/stability/map_csv.h"

namespace pupflow::report {
namespace {

constexpr int kWidth = 980, kHeight = 630;  // pixels of a figure

std::string number(double value) {
  return rounded(value, 6);
}

std::string axis_commands(const std::string& which, const MapAxis& axis,
                          const std::vector<double>& edges) {
  const std::string tics = "  set " + which + "tics ", powers = "autofreq format '10^{%T}'\n";
  const std::string text = "  " + std::string(axis.log ? "set" : "unset") + " logscale " + which +
                           "\n  set " + which + "range [" + number(edges.front()) + ":" +
                           number(edges.back()) + "]\n";
  if (!axis.log) return text + tics + "autofreq format '%g'\n";
  // With few powers of ten on the axis the values are its tics.
  if (axis.values.back() / axis.values.front() > 100) return text + tics + powers;
  std::string values;
  double last = 0;
  for (const double value : axis.values) {
    // Numbers with a smaller ratio would overlap.
    constexpr double kLeastRatio = 1.6;
    if (which == "x" && value < kLeastRatio * last) continue;
    values += (values.empty() ? "" : ", ") + number(value);
    last = value;
  }
  return text + tics + "(" + values + ") format '%g'\n";
}

/// Boxes in the colors of the classes.
std::string boxes(const StabilityMap& map, std::size_t m) {
  return "for [c=0:" + std::to_string(kVerdicts - 1) +
         "] file using (column('panel') == " + std::to_string(m) +
         " && column('code') == c ? column('" + map.x.name + "') : NaN):'" + map.y.name +
         "':'x_low':'x_high':'y_low':'y_high' with boxxyerror fs solid 1 noborder lc rgb "
         "word(colors, c + 1) notitle, ";
}

/// A dot in the color of the other class where seeds disagree: in the middle of the cell.
std::string dots(const StabilityMap& map, std::size_t m) {
  const auto middle = [](const MapAxis& axis, const std::string& which) {
    const std::string low = "column('" + which + "_low')", high = "column('" + which + "_high')";
    return axis.log ? "sqrt(" + low + "*" + high + ")" : "(" + low + "+" + high + ")/2";
  };
  std::string text;
  const std::string panel = "column('panel') == " + std::to_string(m);
  const std::string at = middle(map.x, "x") + " : NaN):(" + middle(map.y, "y") + ")";
  for (const std::string ring : {"1.25 lc rgb '#ffffff'", "1.05 lc rgb '#222222'"}) {
    text += "file using (" + panel + " && column('other_code') >= 0 ? " + at +
            " with points pt 7 ps " + ring + " notitle, ";
  }
  text += "for [c=0:" + std::to_string(kVerdicts - 1) + "] file using (" + panel +
          " && column('other_code') == c ? " + at +
          " with points pt 7 ps 0.75 lc rgb word(colors, c + 1) notitle";
  return text;
}

std::string panel(const StabilityMap& map, std::size_t m) {
  const bool first = m == 0;
  std::string text = "  set title '" + map.methods[m].name + "'\n  set xlabel '" + map.x.label +
                     "'\n  " + (first ? "set ylabel '" + map.y.label + "'" : "unset ylabel") +
                     "\n  set lmargin at screen " + (first ? "0.085" : "0.565") +
                     "\n  set rmargin at screen " + (first ? "0.495" : "0.975") +
                     "\n  unset arrow\n";
  std::string plot = "  plot " + boxes(map, m) + dots(map, m);
  int style = 1;
  for (const TheoryLine& line : map.lines) {
    const std::string look = " dt " + std::to_string(style++) + " lc rgb '#000000'";
    if (line.only_method >= 0 && line.only_method != static_cast<int>(m)) continue;
    if (line.y.empty()) {
      const std::string ends = "  set arrow from first " + number(line.vertical) +
                               ",graph 0 to first " + number(line.vertical) +
                               ",graph 1 nohead front";
      text += ends + " lw 4 lc rgb '#ffffff'\n" + ends + " lw 1.6" + look + "\n";
    } else {
      plot += ", " + line.y + " with lines lw 4 lc rgb '#ffffff' notitle, " + line.y +
              " with lines lw 1.6" + look + " notitle";
    }
  }
  const std::string mark = ", '+' using (" + number(map.x.get(Params{})) + "):(" +
                           number(map.y.get(Params{})) + ") every ::0::0 with points pt 6 ps ";
  plot += mark + "1.7 lw 4 lc rgb '#ffffff' notitle" + mark + "1.7 lw 2 lc rgb '#000000' notitle\n";
  return text + plot;
}

/// Places of the legend: three columns, rows from the top, in pixels from the lower left.
class Legend {
 public:
  /// Commands for a label, after its mark `left` of it was drawn by `mark(x, y)`.
  std::string add(const std::string& label, const std::function<std::string(int, int)>& mark) {
    const int x = 30 + 300 * (count_ % 3), y = 160 - 26 * (count_ / 3);
    ++count_;
    return mark(x, y) + "  set label '" + label + "' at screen " + at(x + 52, y) + " left\n";
  }
  static std::string at(int x, int y) {
    return number(static_cast<double>(x) / kWidth) + "," + number(static_cast<double>(y) / kHeight);
  }

 private:
  int count_ = 0;
};

std::string swatch(int x, int y, const std::string& color) {
  return "  set object rectangle from screen " + Legend::at(x, y - 8) + " to screen " +
         Legend::at(x + 38, y + 8) + " fc rgb '" + color + "' fs solid border lc rgb '#888888'\n";
}

std::string dot(int x, int y, const std::string& look) {
  return "  set label '' at screen " + Legend::at(x + 19, y) + " point " + look + "\n";
}

/// An empty plot over all panels, whose objects and labels explain colors, marks and lines.
std::string legend(const StabilityMap& map, bool refuses) {
  Legend legend;
  std::string text =
      "  unset title; unset border; unset tics; unset xlabel; unset ylabel; unset arrow\n"
      "  unset logscale; set xrange [0:1]; set yrange [0:1]\n"
      "  set lmargin at screen 0; set rmargin at screen 1\n"
      "  set tmargin at screen 0.3; set bmargin at screen 0\n";
  for (const Class& look : classes()) {
    text += legend.add(std::string(look.name),
                       [&](int x, int y) { return swatch(x, y, std::string(look.color)); });
  }
  if (map.seeds > 1) {
    text += legend.add("seeds disagree: the other class", [](int x, int y) {
      return swatch(x, y, std::string(classes()[0].color)) +
             dot(x, y, "pt 7 ps 1.05 lc rgb '#222222'") +
             dot(x, y, "pt 7 ps 0.75 lc rgb '" + std::string(classes()[1].color) + "'");
    });
  }
  text += legend.add("default",
                     [](int x, int y) { return dot(x, y, "pt 6 ps 1.7 lw 2 lc rgb '#000000'"); });
  if (refuses) {
    text += legend.add("refused", [](int x, int y) { return swatch(x, y, "#FFFFFF"); });
  }
  int style = 1;
  for (const TheoryLine& line : map.lines) {
    text += legend.add(line.title, [&](int x, int y) {
      return "  set arrow from screen " + Legend::at(x, y) + " to screen " + Legend::at(x + 42, y) +
             " nohead lw 1.6 dt " + std::to_string(style++) + " lc rgb '#000000'\n";
    });
  }
  return text + "  plot NaN notitle\n  unset object; unset label; unset arrow\n";
}

std::string figure_commands(const StabilityMap& map, bool refuses) {
  std::string colors;
  for (const Class& look : classes()) colors += std::string(look.color) + " ";
  std::string text = "  file = '" + map.name + ".csv'\n  colors = '" + colors +
                     "'\n  set multiplot\n  set samples 400\n  unset key\n"
                     "  set border 15 lc '#444444'; set tics front nomirror out\n"
                     "  set tmargin at screen 0.94; set bmargin at screen 0.385\n" +
                     axis_commands("x", map.x, edges_of(map.x)) +
                     axis_commands("y", map.y, edges_of(map.y));
  for (std::size_t m = 0; m < map.methods.size(); ++m) text += panel(map, m);
  return text + legend(map, refuses) + "  unset multiplot\n";
}

bool any_refused(const MapResult& result) {
  for (const auto& panel : result) {
    for (const auto& row : panel) {
      for (const Cell& cell : row) {
        if (!cell.refused.empty()) return true;
      }
    }
  }
  return false;
}

/// One row of the page's table: cells by class.
io::Row count_row(const Method& method, const std::vector<std::vector<Cell>>& cells) {
  std::vector<int> counts(kVerdicts);
  std::int64_t first = 0, last = 0;
  int all = 0, refused = 0, split = 0;
  for (const auto& row : cells) {
    for (const Cell& cell : row) {
      ++all;
      if (!cell.refused.empty()) {
        ++refused;
        continue;
      }
      ++counts[static_cast<std::size_t>(cell.verdict())];
      split += cell.other() ? 1 : 0;
      for (const Trial& trial : cell.trials) {
        if (trial.status.ok()) continue;
        first = first == 0 ? trial.status.step : std::min(first, trial.status.step);
        last = std::max(last, trial.status.step);
      }
    }
  }
  io::Row row{method.name};
  for (const int count : counts) row.push_back(std::to_string(count));
  for (const int count : {refused, all, split}) row.push_back(std::to_string(count));
  row.push_back(first == 0 ? "-" : std::to_string(first) + " … " + std::to_string(last));
  return row;
}

}  // namespace

void show_map(Report& report, const StabilityMap& map, const MapResult& result) {
  report.subheading(map.title);
  report.text(map.words);
  write_csv(report, map, result);
  report.figure(map.name, map.title + ", " + map.methods[0].name + " and " + map.methods[1].name,
                figure_commands(map, any_refused(result)), map.base, kWidth, kHeight);
  std::vector<io::Row> table{{"cells"}};
  for (const Class& one : classes()) table[0].emplace_back(one.name);
  table[0].insert(table[0].end(), {"refused", "all", "seeds disagree", "bad steps"});
  for (std::size_t m = 0; m < map.methods.size(); ++m) {
    table.push_back(count_row(map.methods[m], result[m]));
  }
  report.table(table);
  report.text("Numbers: [" + map.name + ".csv](" + map.name + ".csv).");
}

}  // namespace pupflow::report
