// The axes of the maps of the stability report.
#pragma once

#include <string>
#include <vector>

#include "pupflow/parameters.h"

namespace pupflow::report {

/// The parameter along one side of a map, and its values in rising order.
struct MapAxis {
  std::string name;  // of its CSV column: a parameter, or a ratio of two
  std::string label;
  bool log = false;
  std::vector<double> values;
  double least = 0, most = 0;  // limits of the drawn cells
  double (*get)(const Params&) = nullptr;
  void (*set)(Params&, double) = nullptr;
};

using Values = std::vector<double>;

/// `count` evenly spaced values from `from` to `to`.
Values evenly(double from, double to, int count);

/// `per_decade` values in each decade from 10^from to 10^to.
Values decades(int from, int to, int per_decade);

/// A parameter, by name, and its values.
MapAxis along(const std::string& parameter, const std::string& label, bool log, Values values);

// Axes of several maps, with few values when `quick`.
MapAxis alpha_axis(bool quick);
MapAxis step_axis(bool quick);
MapAxis pups_axis(bool quick);

/// r_point over r_pup, where r_pup is fixed.
MapAxis point_axis(bool quick);

/// r_pup over r_arena, where r_arena and r_point / r_pup are fixed. The start spread is limited to
/// the room that the arena has.
MapAxis pup_axis(bool quick);

}  // namespace pupflow::report
