// Where everything stands in the window.
#pragma once

#include "app/window/panels/area.h"

namespace pupflow::window {

/// Rectangles in window coordinates. A narrow window has one side panel that holds everything.
struct Layout {
  Area menu;         // along the top
  Area left, right;  // side panels, below the menu
  Area arena, bar;   // of which the legend of the colors has a strip at the right edge
  Area transport;    // below the arena: the run's buttons, clock and timeline
  bool two_panels = false;
};

/// The layout of a window of that size with widgets of that scale; without panels the arena has it
/// all but menu and transport.
Layout make_layout(float width, float height, float scale, bool panels);

}  // namespace pupflow::window
