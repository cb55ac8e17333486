// OpenGL without a display, by EGL.
#pragma once

#include <memory>

#include "app/context/context.h"

namespace pupflow::context {

/// Tries Mesa's surfaceless platform, then every EGL device, then the default display, and takes
/// the first that gives OpenGL 3.3 core; `report` gets every attempt. Throws Failure(no_context)
/// saying what was tried and what to install when none does.
std::unique_ptr<Context> make_headless(ContextReport& report);

/// The same attempts, without keeping the context and without throwing for want of one.
ContextReport probe_headless();

}  // namespace pupflow::context
