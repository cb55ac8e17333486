// What is drawn over the arena: banner of a bad status, messages.
#pragma once

#include <string>

#include "app/window/panels/area.h"
#include "app/window/panels/panel.h"

namespace pupflow::window {

/// Says where the numbers went wrong, and offers to start again and to show the pup.
void draw_bad_status(const Area& arena, const PanelInput& in);

/// At the top of the arena, while the numbers are good: a line for each warning, and the offer of
/// another start for a litter that does not fit into a column.
void draw_notices(const Area& arena, const PanelInput& in);

/// A line at the bottom of the arena.
void draw_message(const Area& arena, const std::string& text);

}  // namespace pupflow::window
