// The help: what keys and mouse do.
#pragma once

#include "app/window/panels/panel.h"

namespace pupflow::window {

/// Shows the key table and the mouse table in the middle of the window, when asked for. Scrolls what
/// the window has no room for; the Close button stays in reach.
void draw_help(const PanelInput& in);

}  // namespace pupflow::window
