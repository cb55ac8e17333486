#include "app/window/panel_keys.h"

#include <imgui.h>
#include <imgui_internal.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "app/window/imgui_compat.h"

namespace pupflow::window {
namespace {

constexpr std::array kNavigation{GLFW_KEY_SPACE,     GLFW_KEY_ENTER, GLFW_KEY_KP_ENTER,
                                 GLFW_KEY_TAB,       GLFW_KEY_LEFT,  GLFW_KEY_RIGHT,
                                 GLFW_KEY_UP,        GLFW_KEY_DOWN,  GLFW_KEY_PAGE_UP,
                                 GLFW_KEY_PAGE_DOWN, GLFW_KEY_HOME,  GLFW_KEY_END};

bool popup_open() {
  return GImGui->OpenPopupStack.Size > 0;
}

}  // namespace

bool keys_work_panels() {
  return (ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0;
}

void leave_panels() {
  ImGui::GetIO().ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
  ImGui::FocusWindow(nullptr);
}

void work_next_panel(std::span<const char* const> panels) {
  auto next = panels.begin();
  if (keys_work_panels() && GImGui->NavWindow != nullptr) {
    const auto present = std::find(panels.begin(), panels.end(),
                                   std::string_view(GImGui->NavWindow->RootWindow->Name));
    if (present != panels.end() && present + 1 != panels.end()) next = present + 1;
  }
  ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  if (ImGuiWindow* window = ImGui::FindWindowByName(*next)) {
    const auto& parts = window->DC.ChildWindows;  // its widgets stand in the first one, if any
    if (parts.Size > 0) window = parts[0];
    ImGui::FocusWindow(window);
    const bool menu = (window->Flags & ImGuiWindowFlags_MenuBar) != 0;
    GImGui->NavLayer = menu ? ImGuiNavLayer_Menu : ImGuiNavLayer_Main;
    ImGui::NavInitWindow(window, true);
    show_key_cursor();
  }
}

bool panels_take(int key) {
  if (!keys_work_panels()) return false;
  if (key == GLFW_KEY_ESCAPE) return popup_open() || ImGui::IsAnyItemActive();
  return std::count(kNavigation.begin(), kNavigation.end(), key) > 0;
}

bool close_front_popup() {
  if (!popup_open()) return false;
  ImGui::ClosePopupToLevel(GImGui->OpenPopupStack.Size - 1, true);
  return true;
}

}  // namespace pupflow::window
