// A rectangle of the window.
#pragma once

#include <imgui.h>

namespace pupflow::window {

/// A rectangle in window coordinates.
struct Area {
  ImVec2 corner, size;
  ImVec2 middle() const { return {corner.x + size.x / 2, corner.y + size.y / 2}; }
  bool holds(ImVec2 place) const {
    return place.x >= corner.x && place.y >= corner.y && place.x < corner.x + size.x &&
           place.y < corner.y + size.y;
  }
};

}  // namespace pupflow::window
