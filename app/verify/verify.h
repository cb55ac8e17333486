// Repeats the run behind an output of this program and compares.
#pragma once

#include <string>

#include "app/verify/verdict.h"

namespace pupflow::verify {

/// Repeats what `path` shows: a metrics or pups CSV, a table of runs or the folder of a sweep, a
/// recording, a checkpoint, a picture of render, figure1 or the window. Throws io::Failure: bad_input when the
/// file does not hold all that made it, bad_file, interrupted.
Verdict verify(const std::string& path, const Options& options);

}  // namespace pupflow::verify
