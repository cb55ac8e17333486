// Entries of lists and menus, and boxes to tick.
#pragma once

#include <imgui.h>

namespace pupflow::window {

/// Calls `draw`, in which entries are as high as buttons. Within one Dear ImGui window.
template <class Draw>
void list_rows(const Draw& draw) {
  const ImGuiStyle& style = ImGui::GetStyle();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {style.ItemSpacing.x, 2 * style.FramePadding.y});
  draw();
  ImGui::PopStyleVar();
}

/// A box to tick, with an edge: without one an empty box is hardly seen.
inline bool check_box(const char* label, bool* on) {
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
  const bool changed = ImGui::Checkbox(label, on);
  ImGui::PopStyleVar();
  return changed;
}

}  // namespace pupflow::window
