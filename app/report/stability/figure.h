// What a map of the stability report shows: its CSV file, figure and table.
#pragma once

#include "app/report/report.h"
#include "app/report/stability/cells.h"

namespace pupflow::report {

/// Writes the map's CSV file and figure, and puts figure and table on the page.
void show_map(Report& report, const StabilityMap& map, const MapResult& result);

}  // namespace pupflow::report
