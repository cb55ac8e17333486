// How the panels look: typeface, sizes, colors.
#pragma once

#include <imgui.h>

#include <string_view>

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

/// Colors, margins and roundings, the latter two `scale` times their ordinary size.
void apply_theme(float scale);

// Colors beyond those of ImGuiCol_.
constexpr ImU32 kInk = IM_COL32(38, 42, 48, 255);
constexpr ImU32 kFaint = IM_COL32(112, 119, 128, 255);
constexpr ImU32 kAccent = IM_COL32(22, 110, 143, 255);
constexpr ImU32 kLine = IM_COL32(208, 213, 219, 255);
constexpr ImU32 kBad = IM_COL32(176, 38, 38, 255);

/// Draws UTF-8 text at `place` on `list`; letters and digits after '_' are set as a subscript.
/// Returns its width.
float draw_rich_text(ImDrawList& list, const Fonts& fonts, ImVec2 place, ImU32 color,
                     std::string_view text);

/// The same as an item in the layout.
void rich_text(const Fonts& fonts, ImU32 color, std::string_view text);

}  // namespace pupflow::window
