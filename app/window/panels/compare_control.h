// Two litters beside each other: what differs between them, chosen and shown.
#pragma once

#include <string>

#include "app/window/panels/panel.h"
#include "app/window/panels/text_entry.h"

namespace pupflow::window {

/// A button that opens the choice; while two litters are compared it says what differs.
class CompareControl {
 public:
  void draw(float width, const PanelInput& in);

 private:
  void draw_choice(const PanelInput& in);
  void draw_value(const Parameter& parameter, const PanelInput& in);
  void draw_end(const PanelInput& in);

  TextEntry entry_;
  std::string parameter_ = "ta", value_, problem_;
  bool from_now_ = false;
};

}  // namespace pupflow::window
