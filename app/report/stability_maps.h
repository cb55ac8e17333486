// Maps of the stability report: two parameters varied, each cell one run, for two ways of stepping.
#pragma once

#include <string>
#include <vector>

#include "app/report/report.h"
#include "app/report/stability_class.h"

namespace pupflow::report {

/// One parameter and its values, rising.
struct MapAxis {
  std::string parameter;  // as in --set
  std::string label;
  bool log = false;
  std::vector<double> values;
};

/// A curve that theory draws on a map: y as a gnuplot expression of x, or a vertical line.
struct TheoryLine {
  std::string title;
  std::string y;         // empty: vertical
  double vertical = 0;   // its x
  int only_method = -1;  // the panel that it holds for; -1: both
};

/// One of the two panels of a map.
struct Method {
  std::string name;  // also in the CSV
  void (*set)(Params&);
};

/// One map: what is varied, about which litter, and what theory says.
struct StabilityMap {
  std::string name;  // of its files
  std::string title;
  std::string words;  // what is seen, for the page
  MapAxis x, y;
  Params base;
  bool heat_alone = false;  // judged by try_heat
  std::vector<Method> methods;
  std::vector<TheoryLine> lines;
};

/// All maps, coarser ones when `quick`.
std::vector<StabilityMap> stability_maps(bool quick);

/// The parameters of one cell; how many steps it takes is part of them.
Params cell_params(const StabilityMap& map, const Method& method, double x, double y);

/// The verdicts of a map: [method][y][x].
using MapResult = std::vector<std::vector<std::vector<Trial>>>;

/// Computes all cells on `options.threads` threads. Throws io::Failure(interrupted).
MapResult compute_map(const StabilityMap& map, const Options& options);

/// Writes the map's CSV file and figure, and puts figure and table on the page.
void show_map(Report& report, const StabilityMap& map, const MapResult& result);

}  // namespace pupflow::report
