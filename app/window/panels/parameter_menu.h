// What can be done with one parameter beside moving its slider: default, scene's value, ramp.
#pragma once

#include <string>

#include "app/window/panels/panel.h"
#include "app/window/panels/text_entry.h"
#include "pupflow/parameters.h"

namespace pupflow::window {

/// The menu that a right click on a parameter opens, one for all rows of a panel.
class ParameterMenu {
 public:
  /// Opens the menu of `parameter` in the present ID scope.
  void open(const Parameter& parameter, const PanelInput& in);

  /// Draws it if it is open, in the same ID scope. True when a value is to be typed.
  bool draw(const Parameter& parameter, const PanelInput& in);

 private:
  void draw_ramp(const Parameter& parameter, const PanelInput& in);
  void start_ramp(const Parameter& parameter, const PanelInput& in);

  TextEntry entry_;
  std::string to_, seconds_ = "10", problem_;  // of the ramp
  bool back_ = false;
};

}  // namespace pupflow::window
