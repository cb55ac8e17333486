// Scene 7 of the error report: the whole litter, where only means over seeds have a right answer.
#pragma once

#include "app/report/report.h"

namespace pupflow::report {

/// How far the means of Figure 2 are off, against processor seconds, for several settings. Puts a
/// section on the page, with litter.csv and a plot.
void litter_section(Report& report);

/// How fast two litters that differ by 1e-9 part. Puts a section on the page, with divergence.csv
/// and a plot.
void divergence_section(Report& report);

/// Factor on the standard error that gives a 95 % interval for the mean of `runs` runs (at least
/// 2): Student's t, by the expansion of Cornish and Fisher.
double interval_factor(std::int64_t runs);

}  // namespace pupflow::report
