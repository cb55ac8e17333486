// All panels of the window, in their places.
#pragma once

#include <span>

#include "app/window/panels/inspector_panel.h"
#include "app/window/panels/layout.h"
#include "app/window/panels/numbers_panel.h"
#include "app/window/panels/overlay_menu.h"
#include "app/window/panels/panel.h"
#include "app/window/panels/parameter_panel.h"
#include "app/window/panels/scene_menu.h"
#include "app/window/panels/transport_panel.h"

namespace pupflow::window {

class Panels {
 public:
  /// Submits all panels and overlays of one frame.
  void draw(const Layout& layout, const PanelInput& in);

  /// The Dear ImGui windows that keys can work, in their order.
  static std::span<const char* const> names();

  /// The height that the transport's content took in the last frame.
  float transport_height() const { return transport_height_; }

 private:
  OverlayMenu overlays_;
  SceneMenu scenes_;
  ParameterPanel parameters_;
  InspectorPanel inspector_;
  NumbersPanel numbers_;
  TransportPanel transport_;
  float transport_height_ = 0;
};

}  // namespace pupflow::window
