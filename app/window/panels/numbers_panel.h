// The observables: as numbers, and as plots of the recent past.
#pragma once

#include "app/window/session/session.h"
#include "app/window/test_events.h"
#include "app/window/theme.h"

namespace pupflow::window {

/// Draws both parts into the current Dear ImGui window. True when one of them is open: somebody
/// looks at the observables.
bool draw_numbers_panel(const LiveState& snapshot, const Fonts& fonts, TestEvents& events);

}  // namespace pupflow::window
