#include "app/window/panels/numbers_panel.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace pupflow::window {
namespace {

std::string number(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string text_of(std::string_view words) {
  return std::string(words);
}

void tip(const Field& field) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::SetTooltip("%s\n%s", text_of(field.doc).c_str(), text_of(field.equation).c_str());
}

void draw_numbers(const PanelInput& in) {
  if (!ImGui::BeginTable("numbers", 3)) return;
  const float em = ImGui::GetFontSize();
  ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, 4 * em);
  ImGui::TableSetupColumn("unit", ImGuiTableColumnFlags_WidthFixed, 2.6f * em);
  for (const ObservableField& row : observables()) {
    ImGui::TableNextColumn();
    rich_text(in.fonts, kInk, text_of(row.label).c_str());
    tip(row);
    ImGui::TableNextColumn();
    const std::string text =
        in.state.observables ? number(*in.state.observables.*row.value, row.digits) : "\u2013";
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(room, 0.0f));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.c_str());
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", text_of(row.unit).c_str());
  }
  ImGui::EndTable();
}

}  // namespace

bool NumbersPanel::draw(const PanelInput& in) {
  const bool numbers = ImGui::CollapsingHeader("numbers", ImGuiTreeNodeFlags_DefaultOpen);
  in.events.widget("numbers");
  if (numbers) draw_numbers(in);
  const bool plots = ImGui::CollapsingHeader("plots", ImGuiTreeNodeFlags_DefaultOpen);
  in.events.widget("plots");
  if (plots) plots_.draw(in);
  return numbers || plots;
}

}  // namespace pupflow::window
