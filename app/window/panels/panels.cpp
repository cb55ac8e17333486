#include "app/window/panels/panels.h"

#include <array>
#include <cmath>
#include <string>

#include "app/window/panels/help.h"
#include "app/window/panels/menu.h"
#include "app/window/panels/overlays.h"

namespace pupflow::window {
namespace {

constexpr const char *kLeft = "left", *kRight = "right", *kTransport = "transport",
                     *kMenu = "##MainMenuBar";  // Dear ImGui's name

void begin_panel(const char* name, const Area& area) {
  ImGui::SetNextWindowPos(area.corner);
  ImGui::SetNextWindowSize(area.size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::Begin(name, nullptr, kPanelWindow);
  ImGui::PopStyleVar();
}

/// What the window being submitted needs to show everything submitted so far.
float content_height() {
  const ImGuiStyle& style = ImGui::GetStyle();
  return std::ceil(ImGui::GetCursorPosY() - style.ItemSpacing.y + style.WindowPadding.y);
}

/// Below what scrolls, and always there, so that nothing moves when it speaks.
void draw_problem(const PanelInput& in) {
  const std::string& text = in.controls.problem.empty() ? in.state.rejected : in.controls.problem;
  if (text.empty()) {
    ImGui::TextDisabled("\u21bb restarts the litter");
    return;
  }
  ImGui::PushTextWrapPos(0);
  colored_text(kBad, text);
  ImGui::PopTextWrapPos();
  in.tips.show(text);
}

}  // namespace

std::span<const char* const> Panels::names() {
  static constexpr std::array kNames{kLeft, kRight, kTransport, kMenu};
  return kNames;
}

void Panels::draw(const Layout& layout, const PanelInput& in) {
  draw_menu(in, overlays_, scenes_);
  in.controls.inspected = {};
  if (layout.left.size.x > 0) {
    begin_panel(kLeft, layout.left);
    constexpr int kProblemLines = 2;
    ImGui::BeginChild("rows", {0, -kProblemLines * ImGui::GetTextLineHeightWithSpacing()});
    parameters_.draw_top(in);
    parameters_.draw_groups(in);
    if (!layout.two_panels) {
      inspector_.draw(in);
      numbers_.draw(in);
    }
    ImGui::EndChild();
    draw_problem(in);
    ImGui::End();
  }
  if (layout.two_panels) {
    begin_panel(kRight, layout.right);
    inspector_.draw(in);
    numbers_.draw(in);
    ImGui::End();
  }
  begin_panel(kTransport, layout.transport);
  transport_.draw(in);
  transport_height_ = content_height();
  ImGui::End();
  draw_notices(layout.arena, in);
  draw_bad_status(layout.arena, in);
  draw_help(in);
}

}  // namespace pupflow::window
