// Sections 7 and 8 of the error report: the litter, which is chaotic, so only means are compared.
#pragma once

#include "app/report/report.h"

namespace pupflow::report {

/// Adds a section: how each choice changes the means of Figure 2, and the time that it takes, for a
/// litter in the cold, at the transition and in the warm, with a CSV file and a plot for each.
void litter_section(Report& report);

/// Adds a section: how fast two litters diverge that differ by 1e-9, with divergence.csv and a
/// plot.
void divergence_section(Report& report);

}  // namespace pupflow::report
