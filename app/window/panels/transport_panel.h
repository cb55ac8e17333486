// Play, pause, step, restart; speed; seed.
#pragma once

#include <cstdint>
#include <string>

#include "app/window/panels/panel.h"

namespace pupflow::window {

/// A random seed.
std::int64_t new_seed();

/// Draws the buttons, the clock, speed and seed into the current Dear ImGui window.
void draw_transport_panel(const PanelInput& in);

}  // namespace pupflow::window
