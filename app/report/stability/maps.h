// Maps of the stability report: two parameters varied, for two ways of computing.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/report/stability/class.h"

namespace pupflow::report {

/// What is varied along one side of a map, and its values, rising.
struct MapAxis {
  std::string name;  // of its CSV column: a parameter, or a ratio of two
  std::string label;
  bool log = false;
  std::vector<double> values;
  double least = 0, most = 0;  // what a cell may not be drawn beyond
  double (*get)(const Params&) = nullptr;
  void (*set)(Params&, double) = nullptr;
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

/// Judges one run; nothing when it was told to stop.
using Judge = std::optional<Trial> (*)(const Params&, const std::function<bool()>&);

/// One map: what is varied, about which litter, and what theory says.
struct StabilityMap {
  std::string name;  // of its files
  std::string title;
  std::string words;  // what is seen, for the page
  MapAxis x, y;
  std::vector<Method> methods;
  Params base;
  Judge judge = try_litter;
  int seeds = 3;  // runs of a cell, an odd number
  std::vector<TheoryLine> lines = {};
};

/// All maps, coarser ones when `quick`.
std::vector<StabilityMap> stability_maps(bool quick);

/// The parameters of one cell's run with this seed; how many steps it takes is part of them.
/// Unsound (check, params.h) where the cell is one that the program refuses.
Params cell_params(const StabilityMap& map, const Method& method, double x, double y,
                   std::int64_t seed);

}  // namespace pupflow::report
