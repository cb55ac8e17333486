// All panels of the window, in their places.
#pragma once

#include "app/window/panels/layout.h"
#include "app/window/panels/numbers_panel.h"
#include "app/window/panels/panel.h"
#include "app/window/panels/parameter_panel.h"

namespace pupflow::window {

class Panels {
 public:
  /// Submits all panels and overlays of one frame. Returns whether the observables were shown.
  bool draw(const Layout& layout, const PanelInput& in);

 private:
  void draw_parameters(const PanelInput& in);

  ParameterPanel parameters_;
  NumbersPanel numbers_;
};

}  // namespace pupflow::window
