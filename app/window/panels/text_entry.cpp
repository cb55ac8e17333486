#include "app/window/panels/text_entry.h"

#include "app/window/imgui_compat.h"

namespace pupflow::window {
namespace {

constexpr ImGuiInputTextFlags kFlags = ImGuiInputTextFlags_AutoSelectAll;

/// White with an edge, so that it looks like what it is.
void push_look() {
  ImGui::PushStyleColor(ImGuiCol_FrameBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
}

void pop_look() {
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

}  // namespace

bool asks_to_type() {
  const bool clicked = ImGui::IsItemClicked() && ImGui::GetIO().KeyCtrl;
  const bool entered = ImGui::IsItemFocused() && key_pressed(ImGuiKey_Enter);
  return clicked || entered || (ImGui::IsItemClicked() && double_clicked());
}

bool double_clicked() {
  return ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
}

std::optional<std::string> TextEntry::draw(const char* label, std::string_view shown, float width) {
  const ImGuiID id = ImGui::GetID(label);
  const bool mine = id == active_;
  Text fresh{};
  shown.copy(fresh.data(), fresh.size() - 1);
  Text& text = mine ? text_ : fresh;
  if (focus_ == id) {
    ImGui::SetKeyboardFocusHere();
    focus_ = 0;
  }
  ImGui::SetNextItemWidth(width);
  push_look();
  ImGui::InputText(label, text.data(), text.size(), kFlags);
  pop_look();
  if (ImGui::IsItemActive()) {
    if (!mine) {
      active_ = id;
      before_ = shown;
      text_ = text;
    }
    return {};
  }
  if (!mine) return {};
  active_ = 0;
  std::string typed = text_.data();
  if (typed == before_) return {};
  return typed;
}

}  // namespace pupflow::window
