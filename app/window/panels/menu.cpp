#include "app/window/panels/menu.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

namespace pupflow::window {
namespace {

/// The entries of one menu, in their order.
struct Menu {
  const char* title;
  std::array<Action, 8> actions;
  std::size_t count;
};

constexpr std::array kMenus{
    Menu{"Scene", {Action::screenshot, Action::quit}, 2},
    Menu{"Run",
         {Action::play_pause, Action::step, Action::step_many, Action::step_back,
          Action::step_back_many, Action::restart, Action::new_seed},
         7},
    Menu{"Edit", {Action::undo, Action::redo}, 2},
    Menu{"View",
         {Action::reset_camera, Action::top_view, Action::side_view, Action::toggle_panels},
         4},
    Menu{"Help", {Action::toggle_help}, 1},
};

/// At the right end, in every layout: what H does.
void draw_panels_button(const PanelInput& in) {
  const bool shown = in.controls.narrow ? in.controls.drawer : in.controls.panels;
  const char* label = shown ? "Hide panels" : "Panels";
  const float width = ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SameLine(ImGui::GetWindowWidth() - width - ImGui::GetStyle().ItemSpacing.x);
  if (ImGui::SmallButton(label)) in.controls.actions.push_back(Action::toggle_panels);
  in.events.widget("panels");
  in.tips.show("Hide or show the panels (H)");
}

}  // namespace

void draw_menu(const PanelInput& in) {
  if (!ImGui::BeginMainMenuBar()) return;
  for (const Menu& menu : kMenus) {
    const bool open = ImGui::BeginMenu(menu.title);
    in.events.widget(std::string("menu-") + menu.title);
    if (!open) continue;
    for (std::size_t i = 0; i < menu.count; ++i) {
      const KeyRow& row = key_row(menu.actions[i]);
      if (ImGui::MenuItem(row.doc, row.text)) in.controls.actions.push_back(row.action);
      in.events.widget(std::string("menu-") + row.doc);
    }
    ImGui::EndMenu();
  }
  draw_panels_button(in);
  ImGui::EndMainMenuBar();
}

}  // namespace pupflow::window
