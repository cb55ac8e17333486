#include "app/window/panels/panels.h"

#include <string>

#include "app/window/panels/menu.h"
#include "app/window/panels/numbers_panel.h"
#include "app/window/panels/overlays.h"
#include "app/window/panels/transport_panel.h"

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

/// Always there, so that nothing moves when it speaks.
void draw_problem(const PanelInput& in) {
  const std::string& text = in.controls.problem.empty() ? in.state.rejected : in.controls.problem;
  ImGui::PushStyleColor(ImGuiCol_Text, kBad);
  ImGui::TextUnformatted(text.empty() ? " " : text.c_str());
  ImGui::PopStyleColor();
  if (!text.empty()) in.tips.show(text);
}

/// The model as published; the seed and what does not change the model stay.
Params papers_values(const Params& present) {
  Params params;
  params.seed = present.seed;
  params.steps = present.steps;
  params.discard = present.discard;
  params.flow_lag = present.flow_lag;
  params.precision = present.precision;
  return params;
}

}  // namespace

bool Panels::draw(const Layout& layout, const PanelInput& in) {
  bool observed = false;
  draw_menu(in);
  if (in.controls.panels) {
    begin_panel("left", layout.left);
    parameters_.draw_top(in);
    draw_problem(in);
    if (!layout.two_panels) observed = draw_numbers_panel(in);
    draw_parameters(in);
    ImGui::End();
  }
  if (layout.two_panels) {
    begin_panel("right", layout.right);
    observed = draw_numbers_panel(in);
    ImGui::End();
  }
  begin_panel("transport", layout.transport);
  draw_transport_panel(in);
  ImGui::End();
  draw_warnings(layout.arena, in);
  draw_bad_status(layout.arena, in);
  draw_help(layout.arena, in);
  return observed;
}

void Panels::draw_parameters(const PanelInput& in) {
  parameters_.draw_groups(in);
  ImGui::Spacing();
  if (ImGui::Button("Reset to the paper's values", {-1, 0})) {
    in.controls.propose(papers_values(in.controls.params));
  }
  in.events.widget("reset");
  in.tips.show("All but seed and precision. The litter restarts where it must.");
  ImGui::TextDisabled("\u21bb restarts the litter");
}

}  // namespace pupflow::window
