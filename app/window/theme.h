// How the panels look: typeface, sizes, colors.
#pragma once

#include <imgui.h>

#include "app/window/theme_choice.h"

namespace pupflow::window {

/// The typeface in the sizes in use. They belong to the current Dear ImGui context.
struct Fonts {
  ImFont* text = nullptr;
  ImFont* small = nullptr;  // subscripts, labels of plots
  ImFont* title = nullptr;
};

/// Puts the embedded typeface into the font atlas, `scale` times its ordinary size in window
/// coordinates; `density` is framebuffer pixels per window coordinate. The atlas' texture must be
/// made anew afterwards.
Fonts load_fonts(float scale, float density);

/// The colors of a theme.
struct Palette {
  // Text: on panels, less important, that can be worked with, wrong; and the same on paper.
  ImU32 ink, faint, accent, bad;
  ImU32 paper_ink, paper_faint;
  // Surfaces that text stands on. The arena lies on paper in every theme, as pictures do.
  ImU32 paper, panel, menu, popup, bad_panel;
  ImU32 field, field_hovered, field_active;     // of sliders and what is typed into
  ImU32 button, button_hovered, button_active;  // also of list entries
  ImU32 header, header_hovered, header_active;
  // Neither.
  ImU32 line, grab, grab_active;
  // What stands for something in plots and on the timeline: the litter that is compared, the
  // selected pup, T_p, T_a, what other runs gave, pulls.
  ImU32 second, selected, tp, ta, reference, pull;
};

const Palette& palette_of(Theme theme);

/// Of the theme that was applied last; the light one before.
const Palette& palette();

/// A color by what it is for: it is that of the theme in use.
struct Role {
  ImU32 Palette::*color;
  operator ImU32() const { return palette().*color; }  // NOLINT(google-explicit-constructor)
};
constexpr Role kInk{&Palette::ink}, kFaint{&Palette::faint}, kAccent{&Palette::accent},
    kLine{&Palette::line}, kBad{&Palette::bad}, kBadPanel{&Palette::bad_panel},
    kPaperInk{&Palette::paper_ink}, kPaperFaint{&Palette::paper_faint}, kPull{&Palette::pull};

/// A color with an opacity from 0 to 1.
ImU32 faded(ImU32 color, float alpha);

/// Colors, margins and roundings, the latter two `scale` times their ordinary size.
void apply_theme(Theme theme, float scale);

}  // namespace pupflow::window
