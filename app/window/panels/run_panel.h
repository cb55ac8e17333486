// Play, pause, step, restart; speed; seed.
#pragma once

#include <cstdint>
#include <string>

#include "app/window/controls.h"
#include "app/window/test_events.h"

namespace pupflow::window {

/// A random seed.
std::int64_t new_seed();

/// Draws the buttons, the clock, speed and seed into the current Dear ImGui window.
void draw_run_panel(const LiveState& snapshot, Controls& controls, TestEvents& events);

}  // namespace pupflow::window
