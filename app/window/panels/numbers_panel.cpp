#include "app/window/panels/numbers_panel.h"

#include <string>

#include "app/io/celsius.h"
#include "app/io/text.h"
#include "app/window/panels/histogram_panel.h"
#include "app/window/panels/phase_panel.h"

namespace pupflow::window {
namespace {

/// What the quantity is; a temperature in degrees, too.
void tip(const PanelInput& in, const ObservableField& row) {
  std::string text = std::string(row.doc) + '\n' + std::string(row.equation);
  if (io::is_temperature(row) && in.state.observables) {
    text += "\nnow " + io::celsius_text(*in.state.observables.*row.value) +
            "; 0.6 stands for 37 \u00b0C";
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
    rich_text(in.fonts, kInk, row.label);
    tip(in, row);
    ImGui::TableNextColumn();
    const std::string text =
        in.state.observables ? io::formatted("%.*f", row.digits, *in.state.observables.*row.value)
                             : "\u2013";
    ImGui::AlignTextToFramePadding();
    right_text(text);
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", std::string(row.unit).c_str());
  }
  ImGui::EndTable();
}

}  // namespace

void NumbersPanel::draw(const PanelInput& in) {
  const bool numbers = ImGui::CollapsingHeader("numbers", ImGuiTreeNodeFlags_DefaultOpen);
  in.events.widget("numbers");
  if (numbers) draw_numbers(in);
  const bool plots = ImGui::CollapsingHeader("plots", ImGuiTreeNodeFlags_DefaultOpen);
  in.events.widget("plots");
  if (plots) plots_.draw(in);
  draw_phase_panel(in);
  draw_histogram_panel(in);
}

}  // namespace pupflow::window
