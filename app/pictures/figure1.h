// The paper's Figure 1: what the litter looks like from above at several ambient temperatures.
#pragma once

#include "app/pictures/graphics.h"

namespace pupflow::pictures {

/// Runs one litter per temperature and writes the figure. Throws Failure: bad_input, bad_file
/// (before anything is run when the output exists), bad_numbers, no_context, interrupted; nothing
/// is written then.
void figure1(const Figure1Job& job);

}  // namespace pupflow::pictures
