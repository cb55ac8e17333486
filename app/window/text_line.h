// Lines of text with subscripts, set with Dear ImGui.
#pragma once

#include <imgui.h>

#include "app/view/rgb.h"
#include "app/view/text.h"

namespace pupflow::window {

/// The color with an opacity.
inline ImU32 packed(view::Rgb color, double opacity = 1) {
  return IM_COL32(color.r, color.g, color.b, static_cast<int>(255 * opacity + 0.5));
}

/// The width of `line` with text of that size (em), in window coordinates.
double width_of(ImFont& font, const view::TextLine& line, double size);

/// Draws `line` with its baseline at height `y`, to the right of `x`.
void draw_line(ImDrawList& list, ImFont& font, double x, double y, const view::TextLine& line,
               double size, ImU32 color);

/// The place left of `x` where a line must begin to be aligned there.
double aligned(ImFont& font, double x, const view::TextLine& line, double size, view::Align align);

}  // namespace pupflow::window
