// The observables: as numbers, and as plots of the run.
#pragma once

#include "app/window/panels/panel.h"
#include "app/window/panels/plots_panel.h"

namespace pupflow::window {

class NumbersPanel {
 public:
  /// Draws both parts, the phase plot and the histograms into the current Dear ImGui window.
  void draw(const PanelInput& in);

 private:
  PlotsPanel plots_;
};

}  // namespace pupflow::window
