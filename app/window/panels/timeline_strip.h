// The run so far as a strip, with a playhead to drag.
#pragma once

#include <string>

#include "app/window/panels/panel.h"

namespace pupflow::window {

/// Draws the strip into the current Dear ImGui window, `height` high. Below it is a line of text:
/// model time, or what the mouse points at, or `problem` where there is one.
void draw_timeline_strip(float height, const std::string& problem, const PanelInput& in);

}  // namespace pupflow::window
