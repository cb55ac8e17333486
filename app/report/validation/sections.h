// The sections of the validation report: each puts its table, its CSV file and its figure on the
// page. All throw what all_runs throws, and io::Failure(bad_file).
#pragma once

#include "app/report/report.h"

namespace pupflow::report {

/// The three readings of several contacts of one point, side by side over T_a.
void readings_section(Report& report);

/// The paper's window, steps 501 to 1500, beside later ones.
void window_section(Report& report);

/// Where pups are in the long run.
void wall_section(Report& report);

/// Pup flow over several lags.
void flow_section(Report& report);

/// How far bodies run into each other, with each reading.
void overlap_section(Report& report);

/// The same litter in other units of length.
void units_section(Report& report);

/// Where the heat of a litter goes.
void heat_section(Report& report);

/// What pup numbers and a mirror change.
void symmetry_section(Report& report);

/// The three readings with heading = body.
void body_section(Report& report);

}  // namespace pupflow::report
