// Huddling against ambient temperature: the run's path through the transition.
#pragma once

#include "app/window/panels/panel.h"

namespace pupflow::window {

/// Draws it under a heading of its own into the current Dear ImGui window.
void draw_phase_panel(const PanelInput& in);

}  // namespace pupflow::window
