// How T_b and the sizes of groups are spread over the litter as it is now.
#pragma once

#include "app/window/panels/panel.h"

namespace pupflow::window {

/// Draws both under a heading of their own into the current Dear ImGui window.
void draw_histogram_panel(const PanelInput& in);

}  // namespace pupflow::window
