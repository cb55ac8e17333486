// The live window.
#pragma once

#include "app/window/live_job.h"

namespace pupflow::window {

/// Opens the window and runs the litter in it until it is closed. Throws Failure: no_context
/// without a display, bad_input for a bad look or screenshot pattern, interrupted after Ctrl-C.
void run_live(const LiveJob& job);

}  // namespace pupflow::window
