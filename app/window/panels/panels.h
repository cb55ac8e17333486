// Where everything stands in the window: panels at the sides, the arena between them.
#pragma once

#include "app/window/panels/area.h"
#include "app/window/controls.h"
#include "app/window/panels/overlays.h"
#include "app/window/panels/parameter_panel.h"
#include "app/window/session/session.h"
#include "app/window/test_events.h"
#include "app/window/theme.h"

namespace pupflow::window {

/// Rectangles in window coordinates. A narrow window has one panel that holds everything.
struct Layout {
  Area left, right;
  Area arena, bar;  // of which the legend of the colors has a strip at the right edge
  bool two_panels = false;
};

/// The layout of a window of that size with widgets of that scale; without panels the arena has it
/// all.
Layout make_layout(float width, float height, float scale, bool panels);

class Panels {
 public:
  /// Submits all panels and overlays of one frame. What the user asked for is left in `controls`.
  /// `frames_per_second` is 0 while nothing moves. Returns whether the observables were shown.
  bool draw(const Layout& layout, const LiveState& snapshot, double frames_per_second,
            Controls& controls, const Fonts& fonts, TestEvents& events);

 private:
  void draw_parameters(Controls& controls, const Fonts& fonts, TestEvents& events);

  ParameterPanel parameters_;
};

}  // namespace pupflow::window
