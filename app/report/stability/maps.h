// Maps of the stability report: two parameters varied, for two ways of computing.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/report/stability/axes.h"
#include "app/report/stability/class.h"

namespace pupflow::report {

/// A curve from theory on a map: y as a gnuplot expression of x, or a vertical line.
struct TheoryLine {
  std::string title;
  std::string y;         // empty: vertical
  double vertical = 0;   // its x
  int only_method = -1;  // the panel that it is valid for; -1: both
};

/// One of the two panels of a map.
struct Method {
  std::string name;  // also in the CSV
  void (*set)(Params&);
};

/// Classifies one run; empty when it was stopped.
using Classify = std::optional<Trial> (*)(const Params&, const std::function<bool()>&);

/// One map: two axes, two methods, a litter, and curves from theory.
struct StabilityMap {
  std::string name;  // of its files
  std::string title;
  std::string words;  // a paragraph for the page
  MapAxis x, y;
  std::vector<Method> methods;
  Params base;
  Classify classify = try_litter;
  int seeds = 3;  // runs of a cell, an odd number
  std::vector<TheoryLine> lines = {};
};

/// All maps, coarser ones when `quick`.
std::vector<StabilityMap> stability_maps(bool quick);

/// The parameters of one cell's run with this seed; how many steps it takes is part of them.
/// Invalid (check, pupflow/parameters.h) where the program refuses the cell.
Params cell_params(const StabilityMap& map, const Method& method, double x, double y,
                   std::int64_t seed);

}  // namespace pupflow::report
