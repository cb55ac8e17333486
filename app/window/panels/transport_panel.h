// Play, pause, step, restart; timeline; speed; seed.
#pragma once

#include "app/window/panels/compare_control.h"
#include "app/window/panels/panel.h"
#include "app/window/panels/picture_button.h"
#include "app/window/panels/text_entry.h"
#include "app/window/panels/transport_plan.h"

namespace pupflow::window {

/// The run's buttons below the arena.
class TransportPanel {
 public:
  /// Draws the timeline, the buttons, the clock, speed, seed and comparison into the current Dear
  /// ImGui window.
  void draw(const PanelInput& in);

 private:
  void draw_part(TransportPart part, float width, const PanelInput& in);
  void draw_more(float width, const PanelInput& in);
  void draw_speed(float width, const PanelInput& in);
  void draw_seed(float width, const PanelInput& in);

  TextEntry entry_;
  double speed_before_ = 1;  // the slider was pressed
  bool was_as_fast_ = false, typing_ = false;
  CompareControl compare_;
  PictureButton picture_;
};

}  // namespace pupflow::window
