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
         {Action::reset_camera, Action::top_view, Action::side_view, Action::next_pup,
          Action::follow_pup, Action::pups_eye, Action::toggle_panels},
         7},
    Menu{"Help", {Action::toggle_help}, 1},
};

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
  ImGui::EndMainMenuBar();
}

}  // namespace pupflow::window
