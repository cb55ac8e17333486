// Text in panels: with subscripts, small, colored, at the right.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

#include "app/window/theme.h"

namespace pupflow::window {

/// Draws UTF-8 text at `place` on `list`; letters and digits after '_' are set as a subscript.
/// Returns its width.
float draw_rich_text(ImDrawList& list, const Fonts& fonts, ImVec2 place, ImU32 color,
                     std::string_view text);

/// The width that it would have.
float rich_text_width(const Fonts& fonts, std::string_view text);

/// The same as an item in the layout.
void rich_text(const Fonts& fonts, ImU32 color, std::string_view text);

/// Small text, as labels of plots have it.
ImVec2 small_text_size(const Fonts& fonts, const std::string& text);
void small_text(ImDrawList& list, const Fonts& fonts, ImVec2 place, ImU32 color,
                const std::string& text);

/// Small rich text as an item in the layout.
void small_rich_text(const Fonts& fonts, ImU32 color, const std::string& text);

// Items in the layout, in the panels' text.
void colored_text(ImU32 color, const std::string& text);
/// At the right end of what room there is.
void right_text(const std::string& text);
/// Says what is wrong. Takes a line also when `text` is empty, so that nothing moves when it speaks.
void problem_line(const std::string& text);

}  // namespace pupflow::window
