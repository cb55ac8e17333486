// What is drawn over the arena: help, banner of a bad status, messages.
#pragma once

#include <string>

#include "app/window/panels/area.h"
#include "app/window/controls.h"
#include "app/window/test_events.h"
#include "app/window/theme.h"

namespace pupflow::window {

/// The keys and what the mouse does, from their tables.
void draw_help(const Area& arena, Controls& controls, const Fonts& fonts, TestEvents& events);

/// Says where the numbers went wrong and offers to start again.
void draw_bad_status(const Area& arena, const LiveState& snapshot, Controls& controls,
                     const Fonts& fonts, TestEvents& events);

/// A line for each warning at the top of the arena, while the numbers are good.
void draw_warnings(const Area& arena, const LiveState& snapshot);

/// A line at the bottom of the arena.
void draw_message(const Area& arena, const std::string& text);

}  // namespace pupflow::window
