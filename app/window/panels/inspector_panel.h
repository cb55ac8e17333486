// Everything about the selected pup.
#pragma once

#include "app/window/panels/afferent_map_panel.h"
#include "app/window/panels/panel.h"
#include "app/window/pup_values.h"

namespace pupflow::window {

/// The selected pup: its number, whom it touches, its skin, and each field with its curve. Nothing
/// while no pup is selected.
class InspectorPanel {
 public:
  /// Draws it into the current Dear ImGui window, and has steps record what it shows.
  void draw(const PanelInput& in);

 private:
  void draw_buttons(const PanelInput& in) const;
  void draw_touches(const PanelInput& in, int pup) const;
  void draw_fields(const PanelInput& in) const;
  void draw_curve(std::size_t field) const;

  AfferentMapPanel map_;
  PupCurves curves_;
};

}  // namespace pupflow::window
