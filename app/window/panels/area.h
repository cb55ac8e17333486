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

inline bool overlap(const Area& a, const Area& b) {
  return a.corner.x < b.corner.x + b.size.x && b.corner.x < a.corner.x + a.size.x &&
         a.corner.y < b.corner.y + b.size.y && b.corner.y < a.corner.y + a.size.y;
}

}  // namespace pupflow::window
