// The figures of a sweep, drawn by gnuplot from its summary.
#pragma once

#include <string>
#include <vector>

#include "app/study/results.h"

namespace pupflow::study {

/// Draws summary.csv in `folder` with the script that is kept there; it is written where there is
/// none. A script that differs from what this program writes could do anything, so it is run only
/// when `named` names it; `named`, if not empty, is run in place of the one in the folder. Both
/// pictures carry the manifest and the parameters, and are written whole or not at all. Returns an
/// empty text, or one line with the reason why there is no picture (no parameter or more than two
/// vary; no run was fine; gnuplot is missing; the script was edited). Throws io::Failure: bad_file
/// when a file cannot be written or gnuplot fails, interrupted.
std::string draw_plots(const std::string& folder, const Design& design,
                       const std::vector<Summary>& summaries, const std::string& named = {});

}  // namespace pupflow::study
