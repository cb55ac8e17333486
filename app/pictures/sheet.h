// Panels of several litters in one picture.
#pragma once

#include "app/pictures/sheet_job.h"

namespace pupflow::pictures {

/// Runs one litter for each panel and writes the sheet. All panels have one color scale, fitted to
/// all litters, unless each has its own. Throws Failure, and writes nothing then: bad_input (also
/// for sizes that cannot be drawn), bad_file (before anything is run when the output exists),
/// bad_numbers, no_context, interrupted.
void sheet(const SheetJob& job);

}  // namespace pupflow::pictures
