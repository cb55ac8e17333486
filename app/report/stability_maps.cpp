#include "app/report/stability_maps.h"

#include <algorithm>
#include <cmath>

#include "app/io/interrupt.h"
#include "app/report/share_out.h"

namespace pupflow::report {
namespace {

std::vector<double> evenly(double from, double to, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(from + (to - from) * i / (count - 1));
  return values;
}

/// `per_decade` values in each decade from 10^from to 10^to.
std::vector<double> decades(int from, int to, int per_decade) {
  std::vector<double> values;
  for (int i = from * per_decade; i <= to * per_decade; ++i) {
    const double value = std::pow(10, static_cast<double>(i) / per_decade);
    values.push_back(std::stod(rounded(value, 4)));
  }
  return values;
}

MapAxis alpha_axis(bool quick) {
  return {"alpha", "rigidity α", false, quick ? std::vector{0.1, 0.4, 0.7, 1.0} : evenly(0, 1, 21)};
}

MapAxis step_axis(bool quick) {
  return {"dt", "time step h", true,
          quick ? std::vector{0.001, 0.01, 0.1, 1.0} : decades(-3, 0, 5)};
}

const std::vector<Method>& integrators() {
  static const std::vector<Method> both{
      {"predictive", [](Params& p) { p.integrator = Integrator::predictive; }},
      {"explicit", [](Params& p) { p.integrator = Integrator::explicit_; }}};
  return both;
}

const std::vector<Method>& heat_rules() {
  static const std::vector<Method> both{{"exact", [](Params& p) { p.heat = HeatRule::exact; }},
                                        {"euler", [](Params& p) { p.heat = HeatRule::euler; }}};
  return both;
}

/// The ordinary litter, with fewer pups: what they do to each other is the same, in less time.
Params litter(bool quick) {
  Params params;
  params.pups = 6;
  params.steps = quick ? 800 : 1500;
  return params;
}

std::string number(double value) {
  return rounded(value, 6);
}

// A mode of deformation that the fit can represent is multiplied by |lambda| = sqrt(1 - alpha (1 -
// beta)) in each predictive step, all others by sqrt(1 - alpha).
constexpr double kSlow = 0.98, kQuick = 0.9;

StabilityMap alpha_beta(bool quick) {
  StabilityMap map{"alpha_beta", "α × β", "", {}, {}, litter(quick), false, integrators(), {}};
  map.words =
      "A mode of deformation that the fit can represent is multiplied by |λ| = √(1 − α (1 − β)) in "
      "each predictive step; |λ| = 0.98 means that it takes 50 steps to fall to 1/e. In explicit "
      "steps |λ| = 1 whatever α and β are.";
  map.x = alpha_axis(quick);
  map.y = {"beta", "deformation β", false,
           quick ? std::vector{0.0, 0.5, 0.9, 1.0} : evenly(0, 1, 21)};
  for (const double size : {kSlow, kQuick}) {
    map.lines.push_back(
        {"|λ| = √(1 − α (1 − β)) = " + number(size), "1 - " + number(1 - size * size) + " / x", 0});
  }
  return map;
}

TheoryLine crushed(const Params& params) {
  return {"g h² = r_{pup}: a step falls a radius", "",
          std::sqrt(params.pup_radius / params.gravity)};
}

TheoryLine outrun(const Params& params) {
  return {"f h = 2/3: the drive outruns the wall", "", 2 / (3 * params.drive)};
}

StabilityMap step_alpha(bool quick) {
  StabilityMap map{"step_alpha", "h × α", "", {}, {}, litter(quick), false, integrators(), {}};
  map.words =
      "α acts per step, so |λ| does not depend on h: its lines are level. What h does is to let a "
      "body fall, and be driven, further in each step.";
  map.x = step_axis(quick);
  map.y = alpha_axis(quick);
  for (const double size : {kSlow, kQuick}) {
    map.lines.push_back({"|λ| = √(1 − α (1 − β)) = " + number(size),
                         number((1 - size * size) / (1 - map.base.beta)), 0, 0});
  }
  map.lines.push_back(crushed(map.base));
  map.lines.push_back(outrun(map.base));
  return map;
}

StabilityMap step_gravity(bool quick) {
  StabilityMap map{"step_gravity", "h × gravity", "", {}, {}, litter(quick),
                   false,          integrators(), {}};
  map.words =
      "The floor acts once a step. Where a step falls further than a radius, g h² > r_pup, it "
      "finds all points below and flattens the body.";
  map.x = step_axis(quick);
  map.y = {"gravity", "gravity g", true,
           quick ? std::vector{0.1, 10.0, 1000.0, 1e5} : decades(-1, 5, 3)};
  map.lines = {
      {"g h² = r_{pup}: a step falls a radius", number(map.base.pup_radius) + " / x**2", 0},
      outrun(map.base)};
  return map;
}

StabilityMap drive_pups(bool quick) {
  StabilityMap map{"drive_pups", "drive × N", "", {}, {}, litter(quick), false, integrators(), {}};
  map.words =
      "The wall makes v ← (v − 1)/2 outwards in each step, then the drive adds f h: outside the "
      "wall v goes to 2 f h − 1, and above 1/3 that leads away from it, which is f > 2/(3 h).";
  map.x = {"drive", "drive f", true,
           quick ? std::vector{0.1, 1.0, 10.0, 1000.0} : decades(-1, 3, 4)};
  map.y = {"pups", "pups N", true,
           quick ? std::vector{1.0, 3.0, 6.0, 12.0}
                 : std::vector{1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0, 48.0}};
  map.lines = {{"f h = 2/3: the drive outruns the wall", "", 2 / (3 * map.base.dt)}};
  return map;
}

StabilityMap step_k1(bool quick) {
  StabilityMap map{"step_k1", "h × k₁, heat alone", "", {}, {}, litter(quick),
                   true,      heat_rules(),         {}};
  map.words =
      "One pup that touches nobody (A = 1), from T_b(0) to T_a + G/k₁. Forward Euler multiplies "
      "the difference by 1 − k₁ h: beyond 1 it changes sides in every step, beyond 2 it grows. The "
      "exact solution multiplies by e^(−k₁ h).";
  map.base.pups = 1;
  map.base.gravity = map.base.drive = 0;
  map.base.steps = 400;
  map.x = step_axis(quick);
  map.y = {"k1", "conductance to the air k₁", true,
           quick ? std::vector{0.9, 15.0, 150.0, 1500.0} : decades(-1, 4, 5)};
  map.lines = {{"k₁ h = 1", "1 / x", 0, 1}, {"k₁ h = 2", "2 / x", 0, 1}};
  return map;
}

/// Edges of the cells: halfway between neighbours.
std::vector<double> edges_of(const MapAxis& axis) {
  const std::vector<double>& v = axis.values;
  const auto between = [&](double a, double b) {
    return axis.log ? std::sqrt(a * b) : (a + b) / 2;
  };
  const auto beyond = [&](double a, double b) { return axis.log ? a * a / b : 2 * a - b; };
  std::vector<double> edges{between(v[0], beyond(v[0], v[1]))};
  for (std::size_t i = 0; i + 1 < v.size(); ++i) edges.push_back(between(v[i], v[i + 1]));
  edges.push_back(between(v.back(), beyond(v.back(), v[v.size() - 2])));
  const Parameter& parameter = *find_parameter(axis.parameter);
  for (double& edge : edges) edge = std::clamp(edge, parameter.min, parameter.max);
  return edges;
}

void write_csv(const Report& report, const StabilityMap& map, const MapResult& result) {
  io::CsvFile csv = report.csv(map.name, map.base,
                               map.x.parameter + "," + map.y.parameter +
                                   ",method,panel,class,code,bad_step,bad_stage,bad_pup,bad_point,"
                                   "energy,swing,nearest,inverted,x_low,x_high,y_low,y_high");
  const std::vector<double> xs = edges_of(map.x), ys = edges_of(map.y);
  for (std::size_t m = 0; m < map.methods.size(); ++m) {
    for (std::size_t j = 0; j < map.y.values.size(); ++j) {
      for (std::size_t i = 0; i < map.x.values.size(); ++i) {
        const Trial& trial = result[m][j][i];
        const Status& bad = trial.status;
        csv.cell(map.x.values[i]).cell(map.y.values[j]).cell(std::string_view(map.methods[m].name));
        csv.cell(static_cast<std::int64_t>(m));
        csv.cell(verdict_name(trial.verdict)).cell(static_cast<std::int64_t>(trial.verdict));
        csv.cell(bad.step).cell(bad.ok() ? "-" : stage_name(bad.stage));
        csv.cell(std::int64_t{bad.pup}).cell(std::int64_t{bad.point});
        csv.cell(trial.energy).cell(trial.swing).cell(trial.nearest).cell(trial.inverted);
        csv.cell(xs[i]).cell(xs[i + 1]).cell(ys[j]).cell(ys[j + 1]).end_row();
      }
    }
  }
  csv.commit();
}

// One colour a class, from light to dark as from good to bad, and apart for colour-blind readers
// too (after Okabe & Ito 2008).
constexpr const char* kColors = "#DCE6EC #F0E442 #56B4E9 #E69F00 #CC5FA0 #333333";

std::string axis_commands(const std::string& which, const MapAxis& axis,
                          const std::vector<double>& edges) {
  return "  set " + which + "label '" + axis.label + "'\n  " + (axis.log ? "set" : "unset") +
         " logscale " + which + "\n  set " + which + "range [" + number(edges.front()) + ":" +
         number(edges.back()) + "]\n" +
         (axis.log && axis.values.back() / axis.values.front() > 100
              ? "  set format " + which + " '10^{%T}'\n"
              : "  set format " + which + " '%g'\n");
}

std::string panel(const StabilityMap& map, std::size_t m) {
  const Method& method = map.methods[m];
  const bool first = m == 0;
  const std::string chosen = "column('panel') == " + std::to_string(m) + " && column('code') == ";
  std::string text = "  set title '" + method.name + "'\n  set lmargin at screen " +
                     (first ? "0.08" : "0.56") + "\n  set rmargin at screen " +
                     (first ? "0.49" : "0.97") + "\n  unset arrow\n";
  std::string plot = "  plot for [c=0:5] file using (" + chosen + "c ? column('" + map.x.parameter +
                     "') : NaN):'" + map.y.parameter +
                     "':'x_low':'x_high':'y_low':'y_high' with boxxyerror fs solid 1 noborder lc "
                     "rgb word(colors, c + 1) notitle";
  int style = 1;
  for (const TheoryLine& line : map.lines) {
    const std::string look = " dt " + std::to_string(style++) + " lc rgb ";
    if (line.only_method >= 0 && line.only_method != static_cast<int>(m)) continue;
    if (line.y.empty()) {
      const std::string ends = "  set arrow from first " + number(line.vertical) +
                               ",graph 0 to first " + number(line.vertical) +
                               ",graph 1 nohead front";
      text += ends + " lw 4 lc rgb '#ffffff'\n" + ends + " lw 1.6" + look + "'#D40000'\n";
    } else {
      plot += ", " + line.y + " with lines lw 4 lc rgb '#ffffff' notitle, " + line.y +
              " with lines lw 1.6" + look + "'#D40000' notitle";
    }
  }
  const Parameter* x = find_parameter(map.x.parameter);
  const Parameter* y = find_parameter(map.y.parameter);
  const std::string mark = number(x->default_value()) + "," + number(y->default_value());
  plot += ", '+' using (" + number(x->default_value()) + "):(" + number(y->default_value()) +
          ") every ::0::0 with points pt 7 ps 1.3 lc rgb '#000000' notitle, '+' using (" +
          number(x->default_value()) + "):(" + number(y->default_value()) +
          ") every ::0::0 with points pt 7 ps 0.8 lc rgb '#ffffff' notitle\n";
  return text + plot;
}

/// An empty plot at the bottom whose key explains colours and lines.
std::string legend(const StabilityMap& map) {
  std::string text =
      "  unset title; unset border; unset tics; unset xlabel; unset ylabel; unset arrow\n"
      "  unset logscale; set xrange [0:1]; set yrange [0:1]; set lmargin at screen 0.02\n"
      "  set rmargin at screen 0.98; set tmargin at screen 0.2; set bmargin at screen 0.0\n"
      "  set key at screen 0.5,0.175 center center horizontal maxrows 1 Left reverse samplen 1.6 "
      "width 1\n"
      "  plot for [c=0:5] NaN with boxes fs solid 1 lc rgb word(colors, c + 1) title word(classes, "
      "c + 1)";
  int style = 1;
  std::string lines;
  for (const TheoryLine& line : map.lines) {
    lines += ", NaN with lines lw 1.6 dt " + std::to_string(style++) + " lc rgb '#D40000' title '" +
             line.title + "'";
  }
  text +=
      "\n  set key at screen 0.5,0.065 center center horizontal maxcols 2 Left reverse samplen 3 "
      "width 1\n  plot " +
      lines.substr(2) + ", NaN with points pt 6 ps 1.2 lw 2 lc rgb '#000000' title 'default'\n";
  return text;
}

std::string figure_commands(const StabilityMap& map) {
  std::string classes;
  for (int i = 0; i < kVerdicts; ++i) {
    classes += (i > 0 ? " " : "") + std::string(verdict_name(static_cast<Verdict>(i)));
  }
  std::string text =
      "  file = '" + map.name + ".csv'\n  colors = '" + kColors + "'\n  classes = '" + classes +
      "'\n  set multiplot\n  set samples 400\n  unset key\n"
      "  set border 15 lc '#444444'; set tics front nomirror out\n"
      "  set tmargin at screen 0.92; set bmargin at screen 0.34\n" +
      axis_commands("x", map.x, edges_of(map.x)) + axis_commands("y", map.y, edges_of(map.y));
  for (std::size_t m = 0; m < map.methods.size(); ++m) text += panel(map, m);
  return text + legend(map) + "  unset multiplot\n";
}

io::Row count_row(const Method& method, const std::vector<std::vector<Trial>>& trials) {
  std::vector<int> counts(kVerdicts);
  std::int64_t first = 0, last = 0;
  int all = 0;
  for (const auto& row : trials) {
    for (const Trial& trial : row) {
      ++all;
      ++counts[static_cast<std::size_t>(trial.verdict)];
      if (trial.status.ok()) continue;
      first = first == 0 ? trial.status.step : std::min(first, trial.status.step);
      last = std::max(last, trial.status.step);
    }
  }
  io::Row row{method.name};
  for (const int count : counts) row.push_back(std::to_string(count));
  row.push_back(std::to_string(all));
  row.push_back(first == 0 ? "-" : std::to_string(first) + " … " + std::to_string(last));
  return row;
}

}  // namespace

std::vector<StabilityMap> stability_maps(bool quick) {
  return {alpha_beta(quick), step_alpha(quick), step_gravity(quick), drive_pups(quick),
          step_k1(quick)};
}

Params cell_params(const StabilityMap& map, const Method& method, double x, double y) {
  Params params = map.base;
  method.set(params);
  find_parameter(map.x.parameter)->set(params, x);
  find_parameter(map.y.parameter)->set(params, y);
  if (map.heat_alone) return params;
  // With small steps long enough for the litter to have landed.
  constexpr double kSeconds = 8;
  constexpr std::int64_t kMost = 4000;
  const auto needed = static_cast<std::int64_t>(std::min(kSeconds / params.dt, 1e9));
  params.steps = std::max(params.steps, std::min(needed, kMost));
  return params;
}

MapResult compute_map(const StabilityMap& map, const Options& options) {
  const std::size_t columns = map.x.values.size(), rows = map.y.values.size();
  MapResult result(map.methods.size(),
                   std::vector<std::vector<Trial>>(rows, std::vector<Trial>(columns)));
  const auto count = static_cast<std::int64_t>(map.methods.size() * rows * columns);
  share_out("map " + map.title, count, options, [&](std::int64_t task) {
    const auto cell = static_cast<std::size_t>(task);
    const std::size_t m = cell / (rows * columns), j = cell / columns % rows, i = cell % columns;
    const Params params = cell_params(map, map.methods[m], map.x.values[i], map.y.values[j]);
    const auto trial =
        map.heat_alone ? try_heat(params, io::interrupted) : try_litter(params, io::interrupted);
    if (trial) result[m][j][i] = *trial;
  });
  return result;
}

void show_map(Report& report, const StabilityMap& map, const MapResult& result) {
  report.subheading(map.title);
  report.text(map.words);
  write_csv(report, map, result);
  report.figure(map.name, map.title + ", " + map.methods[0].name + " and " + map.methods[1].name,
                figure_commands(map), map.base, 980, 580);
  std::vector<io::Row> table{{"cells"}};
  for (int i = 0; i < kVerdicts; ++i) {
    table[0].push_back(std::string(verdict_name(static_cast<Verdict>(i))));
  }
  table[0].insert(table[0].end(), {"all", "first bad step"});
  for (std::size_t m = 0; m < map.methods.size(); ++m) {
    table.push_back(count_row(map.methods[m], result[m]));
  }
  report.table(table);
  report.text("Numbers: [" + map.name + ".csv](" + map.name + ".csv).");
}

}  // namespace pupflow::report
