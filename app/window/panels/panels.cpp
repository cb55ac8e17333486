#include "app/window/panels/panels.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "app/window/panels/legend.h"
#include "app/window/panels/numbers_panel.h"
#include "app/window/panels/run_panel.h"

namespace pupflow::window {
namespace {

constexpr float kLeftWidth = 424, kRightWidth = 290, kLeastArena = 400;

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

/// A list of choices. `choices` says each of them by `choice(name, label, chosen)`, which returns
/// whether it was picked.
template <class Choices>
void draw_combo(const char* label, const char* name, std::string_view present, TestEvents& events,
                const Choices& choices) {
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 11);
  const bool open =
      ImGui::BeginCombo(label, std::string(present).c_str(), ImGuiComboFlags_HeightLargest);
  events.widget(name);
  if (!open) return;
  choices([&](std::string_view item, std::string_view text, bool chosen) {
    const std::string shown = std::string(text) + "##" + std::string(item);
    const bool picked = ImGui::Selectable(shown.c_str(), chosen);
    events.widget(std::string(name) + '-' + std::string(item));
    return picked;
  });
  ImGui::EndCombo();
}

void draw_field_choice(Controls& controls, TestEvents& events) {
  const LitterField& present = *controls.look.scale.field;
  draw_combo("colors", "color_by", present.label, events, [&](const auto& choice) {
    for (const auto table : {pup_fields(), afferent_fields()}) {
      for (const LitterField& field : table) {
        // By name: the field of the command line is in the executable's own table.
        const bool chosen = field.name == present.name;
        if (choice(field.name, field.label, chosen) && !chosen) controls.color_by(field);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(field.doc).c_str());
      }
    }
  });
}

void draw_map_choice(Controls& controls, TestEvents& events) {
  view::ColorScale& scale = controls.look.scale;
  draw_combo("color map", "colormap", scale.map_name, events, [&](const auto& choice) {
    for (const std::string_view name : view::colormap_names()) {
      if (choice(name, name, name == scale.map_name)) scale.set_map(name);
    }
  });
}

void draw_view(const LiveState& snapshot, double frames_per_second, Controls& controls,
               TestEvents& events) {
  const bool open = ImGui::CollapsingHeader("view", ImGuiTreeNodeFlags_DefaultOpen);
  events.widget("view");
  if (!open) return;
  draw_field_choice(controls, events);
  if (!controls.look.scale.categorical()) draw_map_choice(controls, events);
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
  const float bar = std::min(kLegendWidth * scale, 0.3f * (arena_end - left));
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
