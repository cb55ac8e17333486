#include "app/window/panels/transport_panel.h"

#include <imgui.h>

#include <cstdio>
#include <random>

namespace pupflow::window {
namespace {

void button(const char* label, const char* name, const char* doc, Action action, float width,
            const PanelInput& in) {
  if (ImGui::Button(label, {width, 0})) in.controls.actions.push_back(action);
  in.events.widget(name);
  in.tips.show(doc);
}

void draw_buttons(const PanelInput& in) {
  constexpr int kButtons = 5;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float half = 0.5f * ImGui::GetContentRegionAvail().x;
  const float width = (half - (kButtons - 1) * gap) / kButtons;
  button(in.state.playing ? "Pause##play" : "Play##play", "play", "Play or pause (Space)",
         Action::play_pause, width, in);
  ImGui::SameLine();
  button("Step", "step", "Pause and make one step (Right)", Action::step, width, in);
  ImGui::SameLine();
  button("Restart", "restart", "Start again with the same seed (R)", Action::restart, width, in);
  ImGui::SameLine();
  button("Picture", "screenshot", "Save a picture with all parameters in it (S)",
         Action::screenshot, width, in);
  ImGui::SameLine();
  button("Help", "help", "Keys and mouse (F1)", Action::toggle_help, width, in);
}

void draw_clock(const PanelInput& in) {
  char text[128];
  std::snprintf(text, sizeof text, "%.2f s", in.state.view().time);
  ImGui::TextUnformatted(text);
  ImGui::SameLine();
  ImGui::TextDisabled("of model time, step %lld", static_cast<long long>(in.state.view().step));
  if (!in.state.playing) {
    std::snprintf(text, sizeof text, "paused");
  } else {
    std::snprintf(text, sizeof text, "%.3g \u00d7 real time",
                  in.state.steps_per_second * in.state.view().params.dt);
  }
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text).x);
  ImGui::TextDisabled("%s", text);
}

void draw_speed(const PanelInput& in) {
  const char* label = "as fast as possible";
  const float box = ImGui::GetFrameHeight() + ImGui::CalcTextSize(label).x +
                    ImGui::GetStyle().ItemInnerSpacing.x + ImGui::GetStyle().ItemSpacing.x;
  double speed = in.controls.speed;
  ImGui::SetNextItemWidth(0.55f * ImGui::GetContentRegionAvail().x - box);
  const char* format = in.controls.as_fast ? "speed" : "speed %.3g \u00d7 real time";
  if (ImGui::SliderScalar("##speed", ImGuiDataType_Double, &speed, &Controls::kSlowest,
                          &Controls::kFastest, format, ImGuiSliderFlags_Logarithmic) &&
      speed > 0) {
    in.controls.set_speed(speed);
  }
  in.events.widget("speed");
  in.tips.show("Model time against real time (+ and -, 1 for real time)");
  ImGui::SameLine();
  bool as_fast = in.controls.as_fast;
  if (ImGui::Checkbox(label, &as_fast)) in.controls.set_as_fast(as_fast);
  in.events.widget("as_fast");
  in.tips.show("Step without regard to the clock (F)");
}

void draw_seed(const PanelInput& in) {
  static_assert(sizeof(std::int64_t) == sizeof(ImS64));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("seed");
  ImGui::SameLine();
  const float button_width = ImGui::GetFontSize() * 6;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button_width -
                          ImGui::GetStyle().ItemSpacing.x);
  ImS64 seed = in.controls.typed_seed.value_or(in.controls.params.seed);
  if (ImGui::InputScalar("##seed", ImGuiDataType_S64, &seed)) in.controls.typed_seed = seed;
  in.events.widget("seed");
  if (in.controls.typed_seed && ImGui::IsItemDeactivatedAfterEdit()) {
    Params candidate = in.controls.params;
    candidate.seed = *in.controls.typed_seed;
    in.controls.propose(candidate);
  }
  if (!ImGui::IsItemActive()) in.controls.typed_seed.reset();
  in.tips.show("Fixes every random number. Type another and press Enter: the litter starts again.");
  ImGui::SameLine();
  if (ImGui::Button("New seed", {button_width, 0})) in.controls.actions.push_back(Action::new_seed);
  in.events.widget("new_seed");
  in.tips.show("Start again with a random seed (Shift + R)");
}

}  // namespace

std::int64_t new_seed() {
  std::random_device device;
  return static_cast<std::int64_t>(device() % 1'000'000u);  // short enough to read out and retype
}

void draw_transport_panel(const PanelInput& in) {
  draw_buttons(in);
  ImGui::SameLine();
  draw_clock(in);
  draw_speed(in);
  ImGui::SameLine();
  draw_seed(in);
}

}  // namespace pupflow::window
