// All panels of the window, in their places.
#pragma once

#include "app/window/panels/layout.h"
#include "app/window/panels/panel.h"
#include "app/window/panels/parameter_panel.h"
#include "app/window/panels/transport_panel.h"

namespace pupflow::window {

class Panels {
 public:
  /// Submits all panels and overlays of one frame. Returns whether the observables were shown.
  bool draw(const Layout& layout, const PanelInput& in);

 private:
  ParameterPanel parameters_;
  TransportPanel transport_;
};

}  // namespace pupflow::window
