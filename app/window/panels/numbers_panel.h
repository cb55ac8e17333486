// The observables: as numbers, and as plots of the run.
#pragma once

#include "app/window/panels/panel.h"
#include "app/window/panels/plots_panel.h"

namespace pupflow::window {

class NumbersPanel {
 public:
  /// Draws both parts into the current Dear ImGui window. True when one of them is open: somebody
  /// looks at the observables.
  bool draw(const PanelInput& in);

 private:
  PlotsPanel plots_;
};

}  // namespace pupflow::window
