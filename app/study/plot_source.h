// What a figure draws: the points of a sweep in rising order.
#pragma once

#include <string>
#include <vector>

#include "app/study/results.h"

namespace pupflow::study {

/// The axes that take more than one value.
std::vector<const Axis*> plotted_axes(const Design& design);

/// The different values of an axis in the order in which they are drawn: numbers rise, the names of a
/// choice stay as they were listed.
std::vector<double> drawn_values(const Axis& axis);

/// Where a gnuplot script reads the points.
struct PlotSource {
  std::string
      name;  // as gnuplot reads it: 'summary.csv' where the rows there are in order along the
             // axes, the first one slowest; otherwise a block in the script
  std::string block;  // the commands that make the block; empty where there is none
};

PlotSource plot_source(const Design& design, const std::vector<Summary>& summaries,
                       const std::vector<const Axis*>& axes);

}  // namespace pupflow::study
