// The gnuplot script that draws a sweep's summary. It stays beside the figure, for users to edit.
#pragma once

#include <string>
#include <vector>

#include "app/study/results.h"

namespace pupflow::study {

/// Four panels for one axis with several values, with the range of T_a in which the litter holds its temperature
/// (transition.h) where that axis is T_a; maps of each observable for two (plot_maps.h), empty otherwise.
/// The script reads summary.csv in its own folder (plot_source.h) and writes the design's NAME.png and NAME.svg
/// there, or files of another name when gnuplot's variable `name` is set.
std::string plot_script(const Design& design, const std::vector<Summary>& summaries);

}  // namespace pupflow::study
