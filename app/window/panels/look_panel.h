// How the litter is shown: the field in colors and its map.
#pragma once

#include "app/window/panels/panel.h"

namespace pupflow::window {

/// Draws it into the current Dear ImGui window.
void draw_look_panel(const PanelInput& in);

}  // namespace pupflow::window
