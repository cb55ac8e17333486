// What of the legend fits into its strip.
#pragma once

#include "app/view/color_scale.h"

namespace pupflow::window {

/// Width that the strip should have, at scale 1.
constexpr float kLegendWidth = 150;

/// A strip narrower or lower than this, in window coordinates, has no legend.
constexpr float kLeastLegendWidth = 60, kLeastLegendHeight = 150;

/// A strip, within its margins, in window coordinates, and the sizes of what stands in it.
struct LegendStrip {
  float height;
  float em;                // of the panels' text
  float row;               // from one line of widgets to the next
  int maps;                // lists of ends and color maps that apply
  bool has_ends;           // whether the bar has ends to type
  int section;             // lines of overlays and drawing
  float least_bar, usual;  // height of the bar in em, below which widgets step aside, and at most
};

/// From the top: field, `maps` lists, upper end, bar, lower end; then the section, or a button that
/// opens it. Widgets step aside one after the other where the strip is low.
struct LegendPlan {
  bool field = false, button = false, ends = false, lists = false, section = false;
  float bar = 0;  // height
};

LegendPlan plan_legend(const LegendStrip& strip);

/// Height in em that the bar, swatches or wheel of a scale needs, and takes where there is room.
float least_bar(const view::ColorScale& scale);
float usual_bar(const view::ColorScale& scale);

}  // namespace pupflow::window
