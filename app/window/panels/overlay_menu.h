// What is drawn over the litter, and how the litter is drawn.
#pragma once

#include "app/window/panels/panel.h"
#include "app/window/panels/text_entry.h"

namespace pupflow::window {

class OverlayMenu {
 public:
  /// The lines that `draw` takes.
  static int lines();

  /// Draws a box for each overlay, the length of trails while they are on, the caption's box, and
  /// the lists of what bodies are drawn as and how well, into the current Dear ImGui window.
  void draw(const PanelInput& in);

 private:
  void draw_trail(const PanelInput& in);

  TextEntry text_;
};

}  // namespace pupflow::window
