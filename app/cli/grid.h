// The parameters that the panels of a sheet differ in, as they are typed: --grid.
#pragma once

#include <string>
#include <vector>

#include "app/graphics/graphics.h"

namespace pupflow::cli {

/// Reads one or two axes: "name=from..to" for whole numbers, or the forms of --vary
/// ("name=from:to:count", "name=from:to:step=S", "name=a,b,c"). Throws io::Failure(bad_input), also
/// for more panels than a sheet may have.
std::vector<pictures::Axis> parse_grid(const std::vector<std::string>& texts);

}  // namespace pupflow::cli
