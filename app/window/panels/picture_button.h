// Saving a picture, and how large pictures and films are.
#pragma once

#include <string>

#include "app/window/panels/panel.h"
#include "app/window/panels/text_entry.h"

namespace pupflow::window {

/// A button that saves a picture, and beside it one for the list of sizes.
class PictureButton {
 public:
  void draw(float width, const PanelInput& in);

 private:
  void draw_sizes(const PanelInput& in);
  void draw_typed(const PanelInput& in);

  TextEntry entry_;
  std::string problem_;  // with what was typed
};

}  // namespace pupflow::window
