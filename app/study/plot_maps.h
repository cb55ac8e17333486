// The figure of a sweep over two parameters.
#pragma once

#include <string>
#include <vector>

#include "app/study/results.h"

namespace pupflow::study {

/// The gnuplot script of a panel for each observable, with its mean as a color: a map of a grid's
/// cells, points at their places for other designs.
std::string map_script(const Design& design, const std::vector<Summary>& summaries,
                       const Axis& down, const Axis& across);

}  // namespace pupflow::study
