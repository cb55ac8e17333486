// What every panel is given.
#pragma once

#include "app/window/controls.h"
#include "app/window/panels/tip.h"
#include "app/window/session/session.h"
#include "app/window/test_events.h"
#include "app/window/theme.h"

namespace pupflow::window {

/// For one frame. Panels read `state` and leave what the user asked for in `controls`.
struct PanelInput {
  const LiveState& state;
  Controls& controls;
  const Fonts& fonts;
  TestEvents& events;
  Tips& tips;
  double frames_per_second = 0;  // 0 while nothing moves
};

}  // namespace pupflow::window
