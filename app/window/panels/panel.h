// What every panel is given.
#pragma once

#include "app/window/controls.h"
#include "app/window/panel_text.h"
#include "app/window/panels/tip.h"
#include "app/window/session/session.h"
#include "app/window/test_events.h"
#include "app/window/theme.h"

namespace pupflow::window {

/// A Dear ImGui window that stays where it is put.
constexpr ImGuiWindowFlags kPanelWindow = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                          ImGuiWindowFlags_NoSavedSettings |
                                          ImGuiWindowFlags_NoBringToFrontOnFocus;

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
