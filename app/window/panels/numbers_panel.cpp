#include "app/window/panels/numbers_panel.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "app/window/panels/celsius.h"
#include "app/window/panels/histogram_panel.h"
#include "app/window/panels/phase_panel.h"

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

/// What the quantity is; a temperature in degrees, too.
void tip(const PanelInput& in, const ObservableField& row) {
  std::string text = text_of(row.doc) + '\n' + text_of(row.equation);
  if (row.observable == Observable::mean_tb && in.state.observables) {
    text += "\nnow " + celsius_text(in.state.observables->mean_tb) + "; 0.6 stands for 37 \u00b0C";
  }
  in.tips.show(text);
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
    tip(in, row);
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
  const bool phase = draw_phase_panel(in);
  const bool histograms = draw_histogram_panel(in);
  return numbers || plots || phase || histograms;
}

}  // namespace pupflow::window
