// The observables: as numbers, and as plots of the recent past.
#pragma once

#include "app/window/panels/panel.h"

namespace pupflow::window {

/// Draws both parts into the current Dear ImGui window. True when one of them is open: somebody
/// looks at the observables.
bool draw_numbers_panel(const PanelInput& in);

}  // namespace pupflow::window
