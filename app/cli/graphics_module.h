// The graphics side of the program: a module beside the executable, loaded when a picture or a
// window is asked for.
#pragma once

#include <string>
#include <vector>

#include "app/pictures/graphics.h"

namespace pupflow::cli {

/// Where the module may be: in the executable's folder (build tree) or the library folder that
/// belongs to it (installed).
std::vector<std::string> module_candidates();

/// Loads the module. Throws Failure(no_context), with the loader's reason and what to install, when
/// it is missing or a library that it needs is.
pictures::Graphics& load_graphics();

}  // namespace pupflow::cli
