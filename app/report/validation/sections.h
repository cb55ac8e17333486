// The sections of the validation report. Each adds its table, its CSV file and its figure to the
// page. All throw what all_runs throws, and io::Failure(bad_file). To add one, write its function in
// a file beside this header and add it to the list.
#pragma once

#include "app/report/report.h"

namespace pupflow::report {

/// The three readings (ContactRule) over T_a.
void readings_section(Report& report);

/// The paper's window, steps 501 to 1500, and later ones.
void window_section(Report& report);

/// Where pups are after long runs.
void wall_section(Report& report);

/// Pup flow over several lags.
void flow_section(Report& report);

/// How far bodies overlap, with each reading.
void overlap_section(Report& report);

/// The same litter in other units of length.
void units_section(Report& report);

/// The heat balance of a litter.
void heat_section(Report& report);

/// The effect of other pup numbers and of a mirror.
void symmetry_section(Report& report);

/// The three readings with heading = body.
void body_section(Report& report);

/// All of them, in the order of the page.
inline constexpr void (*kValidationSections[])(Report&) = {
    readings_section, window_section, wall_section,     flow_section, overlap_section,
    units_section,    heat_section,   symmetry_section, body_section};

}  // namespace pupflow::report
