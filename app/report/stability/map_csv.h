// The CSV file of a map of the stability report.
#pragma once

#include <vector>

#include "app/report/stability/cells.h"

namespace pupflow::report {

/// Edges of the cells along an axis: halfway between neighbours.
std::vector<double> edges_of(const MapAxis& axis);

/// Writes NAME.csv of the map, a row for each cell. Throws io::Failure(bad_file).
void write_csv(const Report& report, const StabilityMap& map, const MapResult& result);

}  // namespace pupflow::report
