#include "app/window/panels/menu.h"

#include <imgui.h>

#include <array>
#include <cctype>
#include <string>
#include <vector>

#include "app/io/text.h"
#include "app/window/panels/color_lists.h"
#include "app/window/panels/list_rows.h"

namespace pupflow::window {
namespace {

constexpr const char* kScene = "Scene";

/// The entries of one menu, in their order.
struct Menu {
  const char* title;
  std::array<Action, 12> actions;
  std::size_t count;
};

constexpr std::array kMenus{
    Menu{kScene,
         {Action::open, Action::save, Action::save_as, Action::copy_command, Action::screenshot,
          Action::record, Action::quit},
         7},
    Menu{"Run",
         {Action::play_pause, Action::step, Action::step_many, Action::step_back,
          Action::step_back_many, Action::restart, Action::new_seed},
         7},
    Menu{"Edit", {Action::undo, Action::redo}, 2},
    Menu{"View",
         {Action::reset_camera, Action::top_view, Action::side_view, Action::next_pup,
          Action::follow_pup, Action::pups_eye, Action::toggle_panels, Action::switch_theme,
          Action::larger, Action::smaller, Action::usual_size, Action::full_screen},
         12},
    Menu{"Help", {Action::toggle_help}, 1},
};

bool has_effect(Action action, const Timeline& run) {
  if (action == Action::undo) return run.can_undo;
  if (action == Action::redo) return run.can_redo;
  return true;
}

std::string capitalized(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// A name for tests: one word.
std::string word(std::string text) {
  std::erase(text, ' ');
  return "menu-" + text;
}

void draw_recent(const PanelInput& in) {
  const std::vector<std::string>& recent = in.controls.recent;
  const bool open = ImGui::BeginMenu("Recent files", !recent.empty());
  in.events.widget("menu-recent");
  if (!open) return;
  for (std::size_t i = 0; i < recent.size(); ++i) {
    const std::string label = recent[i] + "###" + std::to_string(i);
    if (ImGui::MenuItem(label.c_str())) in.controls.open = recent[i];
    in.events.widget("menu-recent-" + std::to_string(i));
  }
  ImGui::EndMenu();
}

void draw_overlays(const PanelInput& in, OverlayMenu& overlays) {
  const bool colors = !in.controls.colors_in_strip;
  const float width = 14 * ImGui::GetFontSize();
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, FLT_MAX});
  const bool open = ImGui::BeginMenu(colors ? "Colors, overlays, drawing" : "Overlays and drawing");
  in.events.widget("menu-overlays");
  if (!open) return;
  if (colors) {
    draw_field_list(in);
    draw_scale_lists(in);
  }
  overlays.draw(in);
  ImGui::EndMenu();
}

/// What a step and a frame cost, left of what stands at the right end.
void draw_rates(const PanelInput& in, float right) {
  if (in.state.microseconds_per_step == 0) return;
  std::string text = io::formatted("%.0f \u00b5s a step", in.state.microseconds_per_step);
  if (in.frames_per_second > 0) text += io::formatted(", %.0f frames/s", in.frames_per_second);
  const float x = right - ImGui::CalcTextSize(text.c_str()).x - 2 * ImGui::GetFontSize();
  if (x < ImGui::GetCursorPosX() + ImGui::GetFontSize()) return;
  ImGui::SetCursorPosX(x);
  ImGui::TextDisabled("%s", text.c_str());
}

constexpr const char* kHidePanels = "Hide panels";

/// At the right end, in every layout: what H does.
void draw_panels_button(const PanelInput& in) {
  const bool shown = in.controls.narrow ? in.controls.drawer : in.controls.panels;
  const char* label = shown ? kHidePanels : "Panels";
  const float width = ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
  const float x = ImGui::GetWindowWidth() - width - ImGui::GetStyle().ItemSpacing.x;
  draw_rates(in, x);
  ImGui::SetCursorPosX(x);
  if (ImGui::Button(label)) in.controls.actions.push_back(Action::toggle_panels);
  in.events.widget("panels");
  in.tips.show("Hide or show the panels (H)");
}

void draw_menus(const PanelInput& in, OverlayMenu& overlays, SceneMenu& scenes) {
  for (const Menu& menu : kMenus) {
    const bool open = ImGui::BeginMenu(menu.title);
    in.events.widget(std::string("menu-") + menu.title);
    if (!open) continue;
    if (menu.title == kScene) {
      scenes.draw(in);
      draw_recent(in);
      ImGui::Separator();
    }
    if (menu.title == std::string_view("View")) {  // first, in reach also in a low window
      draw_overlays(in, overlays);
      ImGui::Separator();
    }
    for (std::size_t i = 0; i < menu.count; ++i) {
      const KeyRow& row = key_row(menu.actions[i]);
      const bool can = has_effect(row.action, in.state.timeline);
      if (ImGui::MenuItem(capitalized(row.doc).c_str(), row.text, false, can)) {
        in.controls.actions.push_back(row.action);
      }
      in.events.widget(word(row.text));
    }
    if (menu.title == std::string_view("Run")) {
      ImGui::MenuItem("Pause when minimised", nullptr, &in.controls.pause_minimised);
      in.events.widget("pause_minimised");
    }
    ImGui::EndMenu();
  }
}

/// Whether the menus stand beside each other in the bar, the button for the panels behind them.
bool menus_fit() {
  const ImGuiStyle& style = ImGui::GetStyle();
  float width = ImGui::CalcTextSize(kHidePanels).x + 4 * style.ItemSpacing.x;
  for (const Menu& menu : kMenus) {
    width += ImGui::CalcTextSize(menu.title).x + 2 * style.ItemSpacing.x;
  }
  return width <= ImGui::GetWindowWidth();
}

}  // namespace

void draw_menu(const PanelInput& in, OverlayMenu& overlays, SceneMenu& scenes) {
  if (!ImGui::BeginMainMenuBar()) return;
  list_rows([&] {
    if (menus_fit()) {
      draw_menus(in, overlays, scenes);
    } else {
      const bool open = ImGui::BeginMenu("Menu");
      in.events.widget("menu");
      if (open) {
        draw_menus(in, overlays, scenes);
        ImGui::EndMenu();
      }
    }
    draw_panels_button(in);
  });
  ImGui::EndMainMenuBar();
}

}  // namespace pupflow::window
