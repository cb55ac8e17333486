// Sliders, combos and tooltips for the rows of the parameter table.
#pragma once

#include <optional>

#include "app/window/panels/panel.h"
#include "pupflow/parameters.h"

namespace pupflow::window {

/// Draws the table's rows into the current Dear ImGui window. Values that act on the next step are
/// proposed while a slider moves; those that restart the litter, and typed ones, when they are
/// done.
class ParameterPanel {
 public:
  /// T_a, rigidity and deformation.
  void draw_top(const PanelInput& in);

  /// All the others that matter in a window, under their groups' headings.
  void draw_groups(const PanelInput& in);

 private:
  struct Draft {  // a value being dragged or typed, not all of it proposed yet
    const Parameter* parameter;
    double value;
  };

  void row(const Parameter& parameter, const PanelInput& in);
  void number(const Parameter& parameter, const PanelInput& in);
  bool slider(const Parameter& parameter, double& value) const;

  std::optional<Draft> draft_;
};

}  // namespace pupflow::window
