#include "app/window/panels/look_panel.h"

#include <string>

namespace pupflow::window {
namespace {

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

void draw_field_choice(const PanelInput& in) {
  const LitterField& present = *in.controls.look.scale.field;
  draw_combo("colors", "color_by", present.label, in.events, [&](const auto& choice) {
    for (const auto table : {pup_fields(), afferent_fields()}) {
      for (const LitterField& field : table) {
        // By name: the field of the command line is in the executable's own table.
        const bool chosen = field.name == present.name;
        if (choice(field.name, field.label, chosen) && !chosen) in.controls.color_by(field);
        in.tips.show(field.doc);
      }
    }
  });
}

void draw_map_choice(const PanelInput& in) {
  view::ColorScale& scale = in.controls.look.scale;
  draw_combo("color map", "colormap", scale.map_name, in.events, [&](const auto& choice) {
    for (const std::string_view name : view::colormap_names()) {
      if (choice(name, name, name == scale.map_name)) scale.set_map(name);
    }
  });
}

}  // namespace

void draw_look_panel(const PanelInput& in) {
  const bool open = ImGui::CollapsingHeader("view", ImGuiTreeNodeFlags_DefaultOpen);
  in.events.widget("view");
  if (!open) return;
  draw_field_choice(in);
  if (!in.controls.look.scale.categorical()) draw_map_choice(in);
  ImGui::TextDisabled("%.0f \u00b5s a step", in.state.microseconds_per_step);
  ImGui::SameLine(0, ImGui::GetFontSize());
  if (in.frames_per_second > 0) {
    ImGui::TextDisabled("%.0f frames/s", in.frames_per_second);
  } else {
    ImGui::TextDisabled("at rest");
  }
}

}  // namespace pupflow::window
