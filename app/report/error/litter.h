// Scene 7 of the error report: the whole litter, where only means over seeds have a right answer.
#pragma once

#include "app/report/report.h"

namespace pupflow::report {

/// What each choice changes in the means of Figure 2, and what time it takes, seed by seed, for a
/// litter in the cold, at the transition and in the warm. Puts a section on the page, with a CSV
/// file and a plot for each.
void litter_section(Report& report);

/// How fast two litters that differ by 1e-9 part. Puts a section on the page, with divergence.csv
/// and a plot.
void divergence_section(Report& report);

}  // namespace pupflow::report
