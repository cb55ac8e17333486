// The graphics side of the program: a module that is loaded when a picture or a window is asked
// for.
#pragma once

#include "app/graphics/graphics.h"

namespace pupflow::cli {

/// Loads the module. Throws Failure(no_context), with the loader's reason and what to install, when
/// it is missing or a library that it needs is.
graphics::Graphics& load_graphics();

}  // namespace pupflow::cli
