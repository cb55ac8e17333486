// Pictures of one litter as it moves.
#pragma once

#include "app/pictures/graphics.h"

namespace pupflow::pictures {

/// Steps the litter once through and writes a frame at each asked step. Throws Failure: bad_input
/// and bad_file (before the first step when an output exists), no_context; bad_numbers and
/// interrupted, which keep the frames written so far and say how many these are.
void render(const RenderJob& job);

}  // namespace pupflow::pictures
