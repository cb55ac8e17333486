// Paints the legend of the colors with Dear ImGui.
#pragma once

#include "app/view/color_bar.h"
#include "app/window/panels/area.h"
#include "app/window/theme.h"

namespace pupflow::window {

/// Paints a legend that was laid out in window coordinates; `ink` for words and marks, `line` for
/// frames and ticks.
void paint_legend(ImDrawList& list, const view::ColorBar& layout, ImU32 ink, ImU32 line);

/// The legend of a fitted scale with its title, on paper, in a strip beside the arena, with T_p
/// marked.
void draw_bare_legend(const Area& strip, const view::ColorScale& scale, double tp);

}  // namespace pupflow::window
