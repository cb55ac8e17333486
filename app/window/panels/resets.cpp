#include "app/window/panels/resets.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "app/io/scene_file.h"
#include "app/window/session/parameter_text.h"

namespace pupflow::window {
namespace {

constexpr std::array<std::string_view, 3> kPresets{"cold", "critical", "warm"};

/// The shipped scenes of kPresets. They are read once.
std::span<const io::Scene> presets() {
  static const std::vector<io::Scene> scenes = [] {
    std::vector<io::Scene> read;
    for (const std::string_view name : kPresets) {
      std::vector<std::string> problems;
      read.push_back(io::load_scene(std::string(name), problems));
    }
    return read;
  }();
  return scenes;
}

/// `model` with what selects or measures a run and does not belong to the model as it is now.
Params reset_to(const Params& model, const Params& present) {
  Params params = model;
  params.seed = present.seed;
  params.steps = present.steps;
  params.discard = present.discard;
  params.flow_lag = present.flow_lag;
  params.precision = present.precision;
  params.schedule = present.schedule;
  return params;
}

void button(const char* label, const char* name, const char* whose, const Params& model,
            float width, const PanelInput& in) {
  const Params& present = in.controls.params;
  const Params wanted = reset_to(model, present);
  const std::string difference = difference_text(present, wanted);
  ImGui::BeginDisabled(difference.empty());
  if (ImGui::Button(label, {width, 0})) in.controls.propose(wanted);
  ImGui::EndDisabled();
  in.events.widget(name);
  if (difference.empty()) {
    in.tips.show("All parameters have " + std::string(whose) + " values.");
    return;
  }
  in.tips.show(difference + (needs_restart(present, wanted) ? "\nThe litter restarts." : "") +
               "\nSeed and precision stay. Ctrl + Z takes it back.");
}

}  // namespace

void draw_presets(const Parameter& parameter, const PanelInput& in) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TableNextColumn();
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const auto count = static_cast<float>(presets().size());
  const float width = (ImGui::GetContentRegionAvail().x - (count - 1) * gap) / count;
  for (const io::Scene& scene : presets()) {
    const double value = parameter.get(scene.params);
    if (&scene != presets().data()) ImGui::SameLine(0, gap);
    const bool here = value == parameter.get(in.controls.params);
    if (here)
      ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (ImGui::Button(scene.title.c_str(), {width, 0})) in.controls.propose(parameter, value);
    if (here) ImGui::PopStyleColor();
    in.events.widget("preset-" + scene.title);
    in.tips.show(label_of(parameter) + " = " + format_value(parameter, value) + ": " +
                 scene.description);
  }
}

void draw_resets(const PanelInput& in) {
  ImGui::Spacing();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  button("Reset to the scene", "reset-scene", "the scene's", in.controls.scene, width, in);
  ImGui::SameLine(0, gap);
  button("Reset to the paper", "reset-paper", "the paper's", Params{}, width, in);
}

}  // namespace pupflow::window
