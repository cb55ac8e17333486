// Paints the legend of the colors with Dear ImGui.
#pragma once

#include "app/view/color_bar.h"
#include "app/window/panels/area.h"
#include "app/window/theme.h"

namespace pupflow::window {

/// Width that the legend of any field needs, at scale 1.
constexpr float kLegendWidth = 128;

/// The legend of a fitted scale in a strip beside the arena, with T_p marked.
void draw_legend(const Area& strip, const view::ColorScale& scale, double tp, const Fonts& fonts);

}  // namespace pupflow::window
