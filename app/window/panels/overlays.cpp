#include "app/window/panels/overlays.h"

#include <algorithm>

namespace pupflow::window {
namespace {

constexpr ImGuiWindowFlags kFloating =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;

}  // namespace

void draw_bad_status(const Area& arena, const PanelInput& in) {
  if (in.state.status.ok()) return;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({arena.middle().x, arena.corner.y + em}, ImGuiCond_Always, {0.5f, 0});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, kBadPanel);
  ImGui::PushStyleColor(ImGuiCol_Border, kBad);
  ImGui::Begin("bad status", nullptr, kFloating);
  ImGui::PushFont(in.fonts.title);
  ImGui::PushStyleColor(ImGuiCol_Text, kBad);
  ImGui::TextUnformatted("The numbers went wrong");
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::PushTextWrapPos(std::min(32 * em, arena.size.x - 4 * em));
  ImGui::TextUnformatted(in.state.status.message().c_str());
  ImGui::TextDisabled(
      "The litter stands as that stage left it. Change what drove it there, then restart.");
  ImGui::PopTextWrapPos();
  if (ImGui::Button("Restart")) in.controls.actions.push_back(Action::restart);
  in.events.widget("bad_restart");
  ImGui::End();
  ImGui::PopStyleColor(2);
}

void draw_warnings(const Area& arena, const PanelInput& in) {
  if (in.state.warnings.empty() || !in.state.status.ok()) return;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({arena.middle().x, arena.corner.y + em}, ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowBgAlpha(0.92f);
  ImGui::Begin("warnings", nullptr, kFloating | ImGuiWindowFlags_NoInputs);
  ImGui::PushStyleColor(ImGuiCol_Text, kBad);
  ImGui::PushTextWrapPos(arena.size.x - 3 * em);
  for (const Warning& warning : in.state.warnings) {
    ImGui::TextUnformatted(("Warning: " + warning.message()).c_str());
  }
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::End();
}

void draw_message(const Area& arena, const std::string& text) {
  if (text.empty()) return;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({arena.middle().x, arena.corner.y + arena.size.y - em}, ImGuiCond_Always,
                          {0.5f, 1});
  ImGui::SetNextWindowBgAlpha(0.92f);
  ImGui::Begin("message", nullptr, kFloating | ImGuiWindowFlags_NoInputs);
  ImGui::PushTextWrapPos(arena.size.x - 3 * em);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
}

}  // namespace pupflow::window
