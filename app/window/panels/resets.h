// Many parameters at once: presets of T_a, back to the scene, back to the paper.
#pragma once

#include "app/window/panels/panel.h"
#include "pupflow/parameters.h"

namespace pupflow::window {

/// The value of `parameter` in the cold, critical and warm scenes, as a table row of buttons.
void draw_presets(const Parameter& parameter, const PanelInput& in);

/// Two buttons. The tooltip of each says what it would change.
void draw_resets(const PanelInput& in);

}  // namespace pupflow::window
