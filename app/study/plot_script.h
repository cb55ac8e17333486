// The gnuplot script that draws a sweep's summary. It stays beside the figure, for users to edit.
#pragma once

#include <string>
#include <vector>

#include "app/study/results.h"

namespace pupflow::study {

/// The axes with more than one value.
std::vector<const Axis*> plotted_axes(const Design& design);

/// Four panels for one such axis, with the range of T_a in which the litter holds its temperature
/// (transition.h) where that axis is T_a; heat maps of each observable for two, empty otherwise.
/// The script reads summary.csv in its own folder and writes the design's NAME.png and NAME.svg
/// there, or files of another name when gnuplot's variable `name` is set.
std::string plot_script(const Design& design, const std::vector<Summary>& summaries);

}  // namespace pupflow::study
