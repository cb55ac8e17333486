// Sliders, combos and tooltips for the rows of the parameter table.
#pragma once

#include <optional>

#include "app/window/panels/panel.h"
#include "app/window/panels/parameter_menu.h"
#include "app/window/panels/text_entry.h"
#include "pupflow/parameters.h"

namespace pupflow::window {

/// Draws the table's rows into the current Dear ImGui window. Values that act on the next step are
/// proposed while a slider moves; those that restart the litter, and typed ones, when they are
/// done.
class ParameterPanel {
 public:
  /// T_a with its presets, rigidity and deformation.
  void draw_top(const PanelInput& in);

  /// All the others that matter in a window, under their groups' headings, and the ways back.
  void draw_groups(const PanelInput& in);

 private:
  struct Draft {  // what a slider shows while it is held
    const Parameter* parameter;
    double value;
    bool proposed;
  };
  struct Pressed {  // a slider, not for the second time
    const Parameter* parameter = nullptr;
    double value = 0;  // until then
    double time = 0;
  };

  void row(const Parameter& parameter, const PanelInput& in);
  void slide(const Parameter& parameter, float width, const PanelInput& in);
  void begin_typing(const Parameter& parameter, const PanelInput& in);
  void type(const Parameter& parameter, float width, const PanelInput& in);

  TextEntry entry_;
  ParameterMenu menu_;
  std::optional<Draft> draft_;
  Pressed pressed_;
  const Parameter* typing_ = nullptr;  // its slider is still held
};

}  // namespace pupflow::window
