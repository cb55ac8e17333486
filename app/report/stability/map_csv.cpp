#include "app/report/stability/map_csv.h"

#include <algorithm>
#include <cmath>

namespace pupflow::report {
namespace {

/// The classes of the runs of a cell, and the warnings of any of them, joined by '/'.
std::string calls_of(const Cell& cell) {
  std::string text;
  for (const Trial& trial : cell.trials) {
    text += (text.empty() ? "" : "/") + std::string(class_of(trial.verdict).name);
  }
  return text.empty() ? "-" : text;
}

std::string warnings_of(const Cell& cell) {
  std::string text;
  for (int kind = 0; kind < kWarningKinds; ++kind) {
    const auto warned = [&](const Trial& trial) {
      return std::any_of(trial.warnings.begin(), trial.warnings.end(),
                         [&](const Warning& w) { return static_cast<int>(w.kind) == kind; });
    };
    if (std::none_of(cell.trials.begin(), cell.trials.end(), warned)) continue;
    text += (text.empty() ? "" : "/") + std::string(warning_name(static_cast<Warning::Kind>(kind)));
  }
  return text.empty() ? "-" : text;
}

/// The columns of a cell between its method and its edges.
void write_cell(io::CsvFile& csv, const Cell& cell) {
  std::string_view called = "refused", others = "-";
  std::int64_t code = -1, other_code = -1, agree = 0;
  if (cell.refused.empty()) {
    called = class_of(cell.verdict()).name;
    code = static_cast<std::int64_t>(cell.verdict());
    agree = cell.agreeing();
    if (const auto other = cell.other()) {
      others = class_of(*other).name;
      other_code = static_cast<std::int64_t>(*other);
    }
  }
  csv.cell(called).cell(code).cell(static_cast<std::int64_t>(cell.trials.size())).cell(agree);
  csv.cell(others).cell(other_code).cell(calls_of(cell)).cell(warnings_of(cell));
  const Trial* lost = cell.lost();
  const Status bad = lost != nullptr ? lost->status : Status{};
  csv.cell(bad.step).cell(bad.ok() ? "-" : stage_name(bad.stage));
  csv.cell(std::int64_t{bad.pup}).cell(std::int64_t{bad.point});
  for (const auto measure : {&Trial::energy, &Trial::swing, &Trial::kinetic, &Trial::nearest,
                             &Trial::inside, &Trial::inverted}) {
    csv.cell(cell.mean(measure));
  }
}

}  // namespace

std::vector<double> edges_of(const MapAxis& axis) {
  const std::vector<double>& v = axis.values;
  const auto between = [&](double a, double b) {
    return axis.log ? std::sqrt(a * b) : (a + b) / 2;
  };
  const auto beyond = [&](double a, double b) { return axis.log ? a * a / b : 2 * a - b; };
  std::vector<double> edges{between(v[0], beyond(v[0], v[1]))};
  for (std::size_t i = 0; i + 1 < v.size(); ++i) edges.push_back(between(v[i], v[i + 1]));
  edges.push_back(between(v.back(), beyond(v.back(), v[v.size() - 2])));
  for (double& edge : edges) edge = std::clamp(edge, axis.least, axis.most);
  return edges;
}

void write_csv(const Report& report, const StabilityMap& map, const MapResult& result) {
  io::CsvFile csv =
      report.csv(map.name, map.base,
                 map.x.name + "," + map.y.name +
                     ",method,panel,class,code,seeds,agree,other,other_code,classes,warnings,"
                     "bad_step,bad_stage,bad_pup,bad_point,energy,swing,kinetic,nearest,inside,"
                     "inverted,x_low,x_high,y_low,y_high");
  const std::vector<double> xs = edges_of(map.x), ys = edges_of(map.y);
  for (std::size_t m = 0; m < map.methods.size(); ++m) {
    for (std::size_t j = 0; j < map.y.values.size(); ++j) {
      for (std::size_t i = 0; i < map.x.values.size(); ++i) {
        csv.cell(map.x.values[i]).cell(map.y.values[j]).cell(std::string_view(map.methods[m].name));
        csv.cell(static_cast<std::int64_t>(m));
        write_cell(csv, result[m][j][i]);
        csv.cell(xs[i]).cell(xs[i + 1]).cell(ys[j]).cell(ys[j + 1]).end_row();
      }
    }
  }
  csv.commit();
}

}  // namespace pupflow::report
