#include "app/window/panels/overlays.h"

#include <algorithm>
#include <string>

#include "app/window/imgui_compat.h"

namespace pupflow::window {
namespace {

constexpr ImGuiWindowFlags kFloating =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;

// A column of so many pups reaches far out of the picture, and takes long to fall.
constexpr int kTallColumn = 100;
constexpr double kColumnStands = 10;  // seconds of model time

void place_on_top(const Area& arena) {
  const float y = arena.corner.y + ImGui::GetFontSize();
  ImGui::SetNextWindowPos({arena.middle().x, y}, ImGuiCond_Always, {0.5f, 0});
}

/// Width for the text of a window over the arena.
float text_room(const Area& arena) {
  return arena.size.x - 4 * ImGui::GetFontSize();
}

void draw_warning(const Warning& warning, const PanelInput& in) {
  ImGui::AlignTextToFramePadding();
  colored_text(kBad, "Warning: " + warning.message());
  ImGui::SameLine();
  const std::string name = "show_" + std::to_string(static_cast<int>(warning.kind));
  if (ImGui::Button(("Show##" + name).c_str())) in.controls.show(warning.pup);
  in.events.widget(name);
}

bool column_is_tall(const PanelInput& in) {
  const LitterView litter = in.state.view();
  return litter.params.start == Start::column && litter.params.pups >= kTallColumn &&
         litter.time < kColumnStands;
}

void offer_carpet(const PanelInput& in) {
  ImGui::TextUnformatted("A column of so many pups falls for long, most of it out of sight.");
  if (ImGui::Button("Start as a carpet")) {
    Params candidate = in.controls.params;
    candidate.start = Start::carpet;
    in.controls.propose(candidate);
  }
  in.events.widget("carpet");
}

}  // namespace

void draw_bad_status(const Area& arena, const PanelInput& in) {
  if (in.state.status.ok()) return;
  const float em = ImGui::GetFontSize();
  place_on_top(arena);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, kBadPanel);
  ImGui::PushStyleColor(ImGuiCol_Border, kBad);
  ImGui::Begin("bad status", nullptr, kFloating);
  push_font(in.fonts.title);
  colored_text(kBad, "The numbers went wrong");
  ImGui::PopFont();
  ImGui::PushTextWrapPos(std::min(32 * em, text_room(arena)));
  ImGui::TextUnformatted(in.state.status.message().c_str());
  ImGui::TextUnformatted(
      "The litter stands as that stage left it. Change what drove it there, then restart.");
  ImGui::PopTextWrapPos();
  if (ImGui::Button("Restart")) in.controls.actions.push_back(Action::restart);
  in.events.widget("bad_restart");
  if (const int pup = in.state.status.pup; pup >= 0) {
    ImGui::SameLine();
    if (ImGui::Button(("Show pup " + std::to_string(pup)).c_str())) in.controls.show(pup);
    in.events.widget("bad_show");
  }
  ImGui::End();
  ImGui::PopStyleColor(2);
}

void draw_notices(const Area& arena, const PanelInput& in) {
  const bool tall = column_is_tall(in);
  if (!in.state.status.ok() || (in.state.warnings.empty() && !tall)) return;
  place_on_top(arena);
  ImGui::SetNextWindowBgAlpha(0.92f);
  ImGui::Begin("notices", nullptr, kFloating);
  ImGui::PushTextWrapPos(text_room(arena));
  for (const Warning& warning : in.state.warnings) draw_warning(warning, in);
  if (tall) offer_carpet(in);
  ImGui::PopTextWrapPos();
  ImGui::End();
}

void draw_message(const Area& arena, const std::string& text) {
  if (text.empty()) return;
  constexpr float kScaleBar = 3;  // room of the scale bar at the lower edge, of the text size
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({arena.middle().x, arena.corner.y + arena.size.y - kScaleBar * em},
                          ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowBgAlpha(0.92f);
  ImGui::Begin("message", nullptr, kFloating | ImGuiWindowFlags_NoInputs);
  ImGui::PushTextWrapPos(arena.size.x - 3 * em);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
}

}  // namespace pupflow::window
