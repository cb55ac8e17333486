// What is drawn over the arena: banner of a bad status, messages.
#pragma once

#include <string>

#include "app/window/panels/area.h"
#include "app/window/panels/panel.h"

namespace pupflow::window {

/// Says where the numbers went wrong and offers to start again.
void draw_bad_status(const Area& arena, const PanelInput& in);

/// A line for each warning at the top of the arena, while the numbers are good.
void draw_warnings(const Area& arena, const PanelInput& in);

/// A line at the bottom of the arena.
void draw_message(const Area& arena, const std::string& text);

}  // namespace pupflow::window
