#include "app/window/panels.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "app/window/numbers_panel.h"
#include "app/window/run_panel.h"

namespace pupflow::window {
namespace {

constexpr float kLeftWidth = 424, kRightWidth = 290, kLeastArena = 400, kBarWidth = 84;

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

void draw_problem(const Controls& controls, const LiveState& snapshot) {
  const std::string& text = controls.problem.empty() ? snapshot.rejected : controls.problem;
  if (text.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, kBad);
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

void draw_view(const LiveState& snapshot, double frames_per_second, Controls& controls,
               TestEvents& events) {
  const bool open = ImGui::CollapsingHeader("view", ImGuiTreeNodeFlags_DefaultOpen);
  events.widget("view");
  if (!open) return;
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 9);
  const bool combo = ImGui::BeginCombo("colour map", controls.look.colormap.c_str());
  events.widget("colormap");
  if (combo) {
    for (const std::string_view name : view::colormap_names()) {
      const std::string text(name);
      if (ImGui::Selectable(text.c_str(), text == controls.look.colormap)) {
        controls.look.colormap = text;
      }
      events.widget("colormap-" + text);
    }
    ImGui::EndCombo();
  }
  ImGui::TextDisabled("%.0f \u00b5s a step", snapshot.microseconds_per_step);
  ImGui::SameLine(0, ImGui::GetFontSize());
  if (frames_per_second > 0) {
    ImGui::TextDisabled("%.0f frames/s", frames_per_second);
  } else {
    ImGui::TextDisabled("at rest");
  }
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

Layout make_layout(float width, float height, float scale, bool panels) {
  Layout layout;
  const float left = panels ? std::min(kLeftWidth * scale, 0.6f * width) : 0;
  const float right = kRightWidth * scale;
  layout.two_panels = panels && width >= left + right + kLeastArena * scale;
  const float arena_end = layout.two_panels ? width - right : width;
  layout.left = {{0, 0}, {left, height}};
  const float bar = std::min(kBarWidth * scale, 0.3f * (arena_end - left));
  layout.arena = {{left, 0}, {arena_end - left - bar, height}};
  layout.bar = {{arena_end - bar, 0}, {bar, height}};
  layout.right = {{arena_end, 0}, {width - arena_end, height}};
  return layout;
}

bool Panels::draw(const Layout& layout, const LiveState& snapshot, double frames_per_second,
                  Controls& controls, const Fonts& fonts, TestEvents& events) {
  bool observed = false;
  if (controls.panels) {
    begin_panel("left", layout.left);
    draw_run_panel(snapshot, controls, events);
    ImGui::Separator();
    parameters_.draw_top(controls, fonts, events);
    draw_problem(controls, snapshot);
    if (!layout.two_panels) {
      observed = draw_numbers_panel(snapshot, fonts, events);
      draw_view(snapshot, frames_per_second, controls, events);
    }
    draw_parameters(controls, fonts, events);
    ImGui::End();
  }
  if (layout.two_panels) {
    begin_panel("right", layout.right);
    observed = draw_numbers_panel(snapshot, fonts, events);
    draw_view(snapshot, frames_per_second, controls, events);
    ImGui::End();
  }
  const view::ColorScale scale(controls.look.colormap, controls.look.scale_min,
                               controls.look.scale_max);
  draw_color_bar(layout.bar, scale, snapshot.view().params.preferred_temperature, fonts);
  draw_warnings(layout.arena, snapshot);
  draw_bad_status(layout.arena, snapshot, controls, fonts, events);
  draw_help(layout.arena, controls, fonts, events);
  return observed;
}

void Panels::draw_parameters(Controls& controls, const Fonts& fonts, TestEvents& events) {
  parameters_.draw_groups(controls, fonts, events);
  ImGui::Spacing();
  if (ImGui::Button("Reset to the paper's values", {-1, 0})) {
    controls.propose(papers_values(controls.params));
  }
  events.widget("reset");
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("All but seed and precision. The litter restarts where it must.");
  }
  ImGui::TextDisabled("\u21bb restarts the litter");
}

}  // namespace pupflow::window
