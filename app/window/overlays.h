// What is drawn over the arena: colour bar, help, banner of a bad status, messages.
#pragma once

#include <string>

#include "app/view/colormap.h"
#include "app/window/controls.h"
#include "app/window/test_events.h"
#include "app/window/theme.h"

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

/// The colours of body temperature in a strip beside the arena, with T_p marked.
void draw_color_bar(const Area& strip, const view::ColorScale& scale, double tp,
                    const Fonts& fonts);

/// The keys and what the mouse does, from their tables.
void draw_help(const Area& arena, Controls& controls, const Fonts& fonts, TestEvents& events);

/// Says where the numbers went wrong and offers to start again.
void draw_bad_status(const Area& arena, const LiveState& snapshot, Controls& controls,
                     const Fonts& fonts, TestEvents& events);

/// A line for each warning at the top of the arena, while the numbers are good.
void draw_warnings(const Area& arena, const LiveState& snapshot);

/// A line at the bottom of the arena.
void draw_message(const Area& arena, const std::string& text);

}  // namespace pupflow::window
