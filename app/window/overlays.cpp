#include "app/window/overlays.h"

#include <algorithm>

#include "app/view/color_bar.h"

namespace pupflow::window {
namespace {

constexpr ImGuiWindowFlags kFloating =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;

ImU32 packed(view::Rgb color) {
  return IM_COL32(color.r, color.g, color.b, 255);
}

/// A bar from `low` (upper left) in as many strips as it has pixels in height.
void draw_strips(ImDrawList& list, ImVec2 low, ImVec2 size, const view::ColorScale& scale) {
  const int strips = std::max(1, static_cast<int>(size.y));
  for (int i = 0; i < strips; ++i) {
    const double share = (i + 0.5) / strips;
    const double value = scale.max + share * (scale.min - scale.max);
    const float y = low.y + size.y * static_cast<float>(i) / static_cast<float>(strips);
    list.AddRectFilled({low.x, y}, {low.x + size.x, y + size.y / static_cast<float>(strips)},
                       packed(scale(value)));
  }
  list.AddRect(low, {low.x + size.x, low.y + size.y}, kFaint);
}

}  // namespace

void draw_color_bar(const Area& strip, const view::ColorScale& scale, double tp,
                    const Fonts& fonts) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float em = ImGui::GetFontSize();
  const ImVec2 size{em, std::min(22 * em, 0.6f * strip.size.y)};
  const ImVec2 low{strip.corner.x + 2.4f * em, strip.middle().y - size.y / 2};
  draw_strips(list, low, size, scale);
  const auto height_of = [&](double value) {
    return low.y + size.y * static_cast<float>((scale.max - value) / (scale.max - scale.min));
  };
  for (const double tick : view::round_ticks(scale.min, scale.max, 5)) {
    const float y = height_of(tick);
    list.AddLine({low.x + size.x, y}, {low.x + size.x + 0.3f * em, y}, kFaint);
    const std::string label = view::tick_label(tick);
    list.AddText({low.x + size.x + 0.5f * em, y - 0.55f * em}, kInk, label.c_str());
  }
  draw_rich_text(list, fonts, {low.x, low.y - 1.8f * em}, kInk, "T_b");
  if (tp < scale.min || tp > scale.max) return;
  const float y = height_of(tp);
  list.AddTriangleFilled({low.x - 0.15f * em, y}, {low.x - 0.7f * em, y - 0.35f * em},
                         {low.x - 0.7f * em, y + 0.35f * em}, kInk);
  draw_rich_text(list, fonts, {low.x - 2.2f * em, y - 0.6f * em}, kInk, "T_p");
}

void draw_help(const Area& arena, Controls& controls, const Fonts& fonts, TestEvents& events) {
  events.help(controls.help);
  if (!controls.help) return;
  ImGui::SetNextWindowPos(arena.middle(), ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::Begin("help", nullptr, kFloating);
  const auto table = [](const char* id, const auto& rows) {
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit)) return;
    for (const auto& row : rows) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(row.text);
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", row.doc);
    }
    ImGui::EndTable();
  };
  const auto heading = [&](const char* text) {
    ImGui::PushFont(fonts.title);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
  };
  heading("Keys");
  table("keys", key_table());
  ImGui::Spacing();
  heading("Mouse");
  table("mouse", mouse_table());
  ImGui::Spacing();
  if (ImGui::Button("Close")) controls.help = false;
  events.widget("close_help");
  ImGui::End();
}

void draw_bad_status(const Area& arena, const LiveState& snapshot, Controls& controls,
                     const Fonts& fonts, TestEvents& events) {
  if (snapshot.status.ok()) return;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({arena.middle().x, arena.corner.y + em}, ImGuiCond_Always, {0.5f, 0});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(253, 236, 234, 255));
  ImGui::PushStyleColor(ImGuiCol_Border, kBad);
  ImGui::Begin("bad status", nullptr, kFloating);
  ImGui::PushFont(fonts.title);
  ImGui::PushStyleColor(ImGuiCol_Text, kBad);
  ImGui::TextUnformatted("The numbers went wrong");
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::PushTextWrapPos(std::min(32 * em, arena.size.x - 4 * em));
  ImGui::TextUnformatted(snapshot.status.message().c_str());
  ImGui::TextDisabled(
      "The litter stands as that stage left it. Change what drove it there, then restart.");
  ImGui::PopTextWrapPos();
  if (ImGui::Button("Restart")) controls.actions.push_back(Action::restart);
  events.widget("bad_restart");
  ImGui::End();
  ImGui::PopStyleColor(2);
}

void draw_warnings(const Area& arena, const LiveState& snapshot) {
  if (snapshot.warnings.empty() || !snapshot.status.ok()) return;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({arena.middle().x, arena.corner.y + em}, ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowBgAlpha(0.92f);
  ImGui::Begin("warnings", nullptr, kFloating | ImGuiWindowFlags_NoInputs);
  ImGui::PushStyleColor(ImGuiCol_Text, kBad);
  ImGui::PushTextWrapPos(arena.size.x - 3 * em);
  for (const Warning& warning : snapshot.warnings) {
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
