// The figures of a sweep, drawn by gnuplot from its summary.
#pragma once

#include <string>
#include <vector>

#include "app/study/results.h"

namespace pupflow::study {

/// Draws summary.csv in `folder`. A script that exists already, perhaps edited by the user, is used
/// unchanged; otherwise it is written. Both pictures carry the manifest and the parameters, and are
/// written whole or not at all. Returns an empty text, or one line with the reason why there is no
/// picture (no parameter or more than two vary; no run was fine; gnuplot is missing). Throws io::Failure:
/// bad_file when a file cannot be written or gnuplot fails, interrupted.
std::string draw_plots(const std::string& folder, const Design& design,
                       const std::vector<Summary>& summaries);

}  // namespace pupflow::study
