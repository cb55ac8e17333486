#include "app/window/panels/panels.h"

#include <string>

#include "app/window/panels/look_panel.h"
#include "app/window/panels/menu.h"
#include "app/window/panels/numbers_panel.h"
#include "app/window/panels/overlays.h"

namespace pupflow::window {
namespace {

constexpr ImGuiWindowFlags kPanel = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

void begin_panel(const char* name, const Area& area) {
  ImGui::SetNextWindowPos(area.corner);
  ImGui::SetNextWindowSize(area.size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::Begin(name, nullptr, kPanel);
  ImGui::PopStyleVar();
}

/// Below what scrolls, and always there, so that nothing moves when it speaks.
void draw_problem(const PanelInput& in) {
  const std::string& text = in.controls.problem.empty() ? in.state.rejected : in.controls.problem;
  if (text.empty()) {
    ImGui::TextDisabled("\u21bb restarts the litter");
    return;
  }
  ImGui::PushStyleColor(ImGuiCol_Text, ImU32{kBad});
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

}  // namespace

bool Panels::draw(const Layout& layout, const PanelInput& in) {
  bool observed = false;
  draw_menu(in);
  if (in.controls.panels) {
    begin_panel("left", layout.left);
    constexpr int kProblemLines = 2;
    ImGui::BeginChild("rows", {0, -kProblemLines * ImGui::GetTextLineHeightWithSpacing()});
    parameters_.draw_top(in);
    parameters_.draw_groups(in);
    if (!layout.two_panels) {
      observed = draw_numbers_panel(in);
      draw_look_panel(in);
    }
    ImGui::EndChild();
    draw_problem(in);
    ImGui::End();
  }
  if (layout.two_panels) {
    begin_panel("right", layout.right);
    observed = draw_numbers_panel(in);
    draw_look_panel(in);
    ImGui::End();
  }
  const float margin = kTransportMargin * ImGui::GetFontSize() / kTransportTextSize;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {margin, margin});
  begin_panel("transport", layout.transport);
  ImGui::PopStyleVar();
  transport_.draw(in);
  ImGui::End();
  draw_warnings(layout.arena, in);
  draw_bad_status(layout.arena, in);
  draw_help(layout.arena, in);
  return observed;
}

}  // namespace pupflow::window
