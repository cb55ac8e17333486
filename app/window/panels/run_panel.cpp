#include "app/window/panels/run_panel.h"

#include <imgui.h>

#include <cstdio>
#include <random>

namespace pupflow::window {
namespace {

void tip(const char* text) {
  if (!ImGui::IsItemHovered() || ImGui::IsItemActive()) return;
  // Beside the panel, where it hides nothing of it.
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth();
  ImGui::SetNextWindowPos({right + 0.3f * ImGui::GetFontSize(), ImGui::GetItemRectMin().y});
  ImGui::SetTooltip("%s", text);
}

void button(const char* label, const char* name, const char* doc, Action action, float width,
            Controls& controls, TestEvents& events) {
  if (ImGui::Button(label, {width, 0})) controls.actions.push_back(action);
  events.widget(name);
  tip(doc);
}

void draw_buttons(const LiveState& snapshot, Controls& controls, TestEvents& events) {
  constexpr int kButtons = 5;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - (kButtons - 1) * gap) / kButtons;
  button(snapshot.playing ? "Pause##play" : "Play##play", "play", "Play or pause (Space)",
         Action::play_pause, width, controls, events);
  ImGui::SameLine();
  button("Step", "step", "Pause and make one step (Right)", Action::step, width, controls, events);
  ImGui::SameLine();
  button("Restart", "restart", "Start again with the same seed (R)", Action::restart, width,
         controls, events);
  ImGui::SameLine();
  button("Picture", "screenshot", "Save a picture with all parameters in it (S)",
         Action::screenshot, width, controls, events);
  ImGui::SameLine();
  button("Help", "help", "Keys and mouse (F1)", Action::toggle_help, width, controls, events);
}

void draw_clock(const LiveState& snapshot) {
  char text[128];
  std::snprintf(text, sizeof text, "%.2f s", snapshot.view().time);
  ImGui::TextUnformatted(text);
  ImGui::SameLine();
  ImGui::TextDisabled("of model time, step %lld", static_cast<long long>(snapshot.view().step));
  if (!snapshot.playing) {
    std::snprintf(text, sizeof text, "paused");
  } else {
    std::snprintf(text, sizeof text, "%.3g \u00d7 real time",
                  snapshot.steps_per_second * snapshot.view().params.dt);
  }
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text).x);
  ImGui::TextDisabled("%s", text);
}

void draw_speed(Controls& controls, TestEvents& events) {
  const char* label = "as fast as possible";
  const float box = ImGui::GetFrameHeight() + ImGui::CalcTextSize(label).x +
                    ImGui::GetStyle().ItemInnerSpacing.x + ImGui::GetStyle().ItemSpacing.x;
  double speed = controls.speed;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - box);
  const char* format = controls.as_fast ? "speed" : "speed %.3g \u00d7 real time";
  if (ImGui::SliderScalar("##speed", ImGuiDataType_Double, &speed, &Controls::kSlowest,
                          &Controls::kFastest, format, ImGuiSliderFlags_Logarithmic) &&
      speed > 0) {
    controls.set_speed(speed);
  }
  events.widget("speed");
  tip("Model time against real time (+ and -, 1 for real time)");
  ImGui::SameLine();
  bool as_fast = controls.as_fast;
  if (ImGui::Checkbox(label, &as_fast)) controls.set_as_fast(as_fast);
  events.widget("as_fast");
  tip("Step without regard to the clock (F)");
}

void draw_seed(Controls& controls, TestEvents& events) {
  static_assert(sizeof(std::int64_t) == sizeof(ImS64));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("seed");
  ImGui::SameLine();
  const float button_width = ImGui::GetFontSize() * 6;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button_width -
                          ImGui::GetStyle().ItemSpacing.x);
  ImS64 seed = controls.typed_seed.value_or(controls.params.seed);
  if (ImGui::InputScalar("##seed", ImGuiDataType_S64, &seed)) controls.typed_seed = seed;
  events.widget("seed");
  if (controls.typed_seed && ImGui::IsItemDeactivatedAfterEdit()) {
    Params candidate = controls.params;
    candidate.seed = *controls.typed_seed;
    controls.propose(candidate);
  }
  if (!ImGui::IsItemActive()) controls.typed_seed.reset();
  tip("Fixes every random number. Type another and press Enter: the litter starts again.");
  ImGui::SameLine();
  if (ImGui::Button("New seed", {button_width, 0})) controls.actions.push_back(Action::new_seed);
  events.widget("new_seed");
  tip("Start again with a random seed (Shift + R)");
}

}  // namespace

std::int64_t new_seed() {
  std::random_device device;
  return static_cast<std::int64_t>(device() % 1'000'000u);  // short enough to read out and retype
}

void draw_run_panel(const LiveState& snapshot, Controls& controls, TestEvents& events) {
  draw_buttons(snapshot, controls, events);
  draw_clock(snapshot);
  draw_speed(controls, events);
  draw_seed(controls, events);
}

}  // namespace pupflow::window
