// Where everything stands in the window.
#pragma once

#include "app/window/panels/area.h"

namespace pupflow::window {

/// What a layout is made for. Lengths in window coordinates.
struct LayoutWish {
  float width = 0, height = 0;  // of the window
  float scale = 1;              // of widgets
  float menu = 20;              // height of the menu bar
  float transport = 110;        // height that the content of the transport needs
  bool panels = true;           // beside the arena, where the window is wide enough for that
  bool drawer = false;          // over the arena, where it is not
};

/// Rectangles in window coordinates; what is not shown has no width.
struct Layout {
  Area menu;         // along the top
  Area left, right;  // side panels, below the menu
  Area arena, bar;   // of which the legend of the colors has a strip at the right edge
  Area transport;    // below the arena: the run's buttons, clock and timeline
  bool two_panels = false;
  bool narrow = false;  // too narrow for panels beside the arena: `left` is a drawer over it
};

/// A wide window has two side panels; a less wide one has one that holds everything; in a narrow
/// one this panel is a drawer. The transport takes what it needs, up to a share of the height; it
/// scrolls beyond. The legend steps aside where it would leave the arena too little.
Layout make_layout(const LayoutWish& wish);

}  // namespace pupflow::window
