#include "app/window/panels/transport_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/io/text.h"
#include "app/window/panels/list_rows.h"
#include "app/window/panels/record_button.h"
#include "app/window/panels/timeline_strip.h"
#include "app/window/typed_number.h"

namespace pupflow::window {
namespace {

constexpr std::array kInMenu{TransportPart::speed, TransportPart::as_fast, TransportPart::seed,
                             TransportPart::compare};

void button(const char* label, const char* name, const char* doc, Action action, float width,
            bool enabled, const PanelInput& in) {
  ImGui::BeginDisabled(!enabled);
  if (ImGui::Button(label, {width, 0})) in.controls.actions.push_back(action);
  ImGui::EndDisabled();
  in.events.widget(name);
  in.tips.show(doc);
}

/// Model time and step; how fast it goes, as measured.
void draw_clock(float width, const PanelInput& in) {
  const LitterView litter = in.state.view();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Dummy({width, ImGui::GetFrameHeight()});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(corner, {corner.x + width, corner.y + ImGui::GetFrameHeight()}, true);
  const float em = ImGui::GetFontSize(), y = corner.y + ImGui::GetStyle().FramePadding.y;
  const std::string time = io::formatted("%.2f s", litter.time);
  const std::string step = io::formatted("step %lld", static_cast<long long>(litter.step));
  const std::string rate =
      in.state.playing
          ? io::formatted("%.3g \u00d7 real time", in.state.steps_per_second * litter.params.dt)
          : std::string("paused");
  list.AddText({corner.x, y}, kInk, time.c_str());
  const float second = std::max(ImGui::CalcTextSize(time.c_str()).x + 0.8f * em, 4.4f * em);
  list.AddText({corner.x + second, y}, kFaint, step.c_str());
  const float third = second + ImGui::CalcTextSize(step.c_str()).x + 0.8f * em;
  const float rest = width - ImGui::CalcTextSize(rate.c_str()).x;
  if (rest >= third) list.AddText({corner.x + rest, y}, kFaint, rate.c_str());
  list.PopClipRect();
}

void draw_as_fast(const PanelInput& in) {
  bool as_fast = in.controls.as_fast;
  if (check_box("as fast as possible", &as_fast)) in.controls.set_as_fast(as_fast);
  in.events.widget("as_fast");
  in.tips.show("Step without regard to the clock (F)");
}

}  // namespace

void TransportPanel::draw(const PanelInput& in) {
  const float em = ImGui::GetFontSize(), gap = kTransportGap * em;
  const bool here = in.controls.problem_at == "speed" || in.controls.problem_at == "seed";
  draw_timeline_strip(std::ceil(kStripHeight * em), here ? in.controls.problem : std::string(), in);
  const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
  const TransportPlan plan = plan_transport(width / em);
  int row = -1;
  for (int i = 0; i < kTransportParts; ++i) {
    const auto part = static_cast<TransportPart>(i);
    if (plan.row_of(part) < 0) continue;
    if (plan.row_of(part) == row) ImGui::SameLine(0, gap);
    row = plan.row_of(part);
    const float rest = left + width - ImGui::GetCursorPosX();
    draw_part(part, plan.ends_row(part) ? rest : std::min(transport_width(part) * em, rest), in);
  }
}

void TransportPanel::draw_part(TransportPart part, float width, const PanelInput& in) {
  const bool sound = in.state.status.ok();
  switch (part) {
    case TransportPart::play:
      button(in.state.playing ? "Pause##play" : "Play##play", "play", "Play or pause (Space)",
             Action::play_pause, width, sound, in);
      break;
    case TransportPart::step_back:
      button("\u25c2##back", "step_back", "Pause and go one step back (Left)", Action::step_back,
             width, in.controls.shown_step(in.state) > in.state.timeline.first, in);
      break;
    case TransportPart::step:
      button("\u25b8##step", "step", "Pause and make one step (Right)", Action::step, width, sound,
             in);
      break;
    case TransportPart::restart:
      button("Restart", "restart", "Start again with the same seed (R)", Action::restart, width,
             true, in);
      break;
    case TransportPart::picture:
      picture_.draw(width, in);
      break;
    case TransportPart::record:
      draw_record_button(width, in);
      break;
    case TransportPart::more:
      draw_more(width, in);
      break;
    case TransportPart::clock:
      draw_clock(width, in);
      break;
    case TransportPart::speed:
      draw_speed(width, in);
      break;
    case TransportPart::as_fast:
      draw_as_fast(in);
      break;
    case TransportPart::seed:
      draw_seed(width, in);
      break;
    case TransportPart::compare:
      compare_.draw(width, in);
      break;
  }
}

void TransportPanel::draw_more(float width, const PanelInput& in) {
  if (ImGui::Button("Speed \u2026", {width, 0})) ImGui::OpenPopup("more");
  in.events.widget("more");
  in.tips.show("Speed, seed, comparison");
  if (!ImGui::BeginPopup("more")) return;
  for (const TransportPart part : kInMenu) draw_part(part, 17 * ImGui::GetFontSize(), in);
  ImGui::EndPopup();
}

void TransportPanel::draw_speed(float width, const PanelInput& in) {
  const float em = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float label = 3 * em, field = 4 * em, unit = 0.8f * em;
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("speed");
  ImGui::SameLine(left + label);
  double speed = in.controls.speed;
  ImGui::SetNextItemWidth(width - label - field - unit - 2 * gap);
  const bool moved = ImGui::SliderScalar("##slider", ImGuiDataType_Double, &speed,
                                         &Controls::kSlowest, &Controls::kFastest, " ",
                                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput);
  in.events.widget("speed");
  in.tips.show("Model time against real time (+ and -, 1 for real time)");
  if (ImGui::IsItemActivated() && !double_clicked()) {
    speed_before_ = in.controls.speed;
    was_as_fast_ = in.controls.as_fast;
  }
  if (asks_to_type()) {
    entry_.focus("##speed");
    typing_ = true;
    if (double_clicked()) {  // what its first click did is taken back
      in.controls.set_speed(speed_before_);
      if (was_as_fast_) in.controls.set_as_fast(true);
    }
  }
  if (moved && !typing_ && speed > 0) in.controls.set_speed(speed);
  if (!ImGui::IsItemActive()) typing_ = false;
  ImGui::SameLine(0, gap);
  const std::string shown = in.controls.speed < Controls::kFastest
                                ? io::formatted("%.3g", in.controls.speed)
                                : io::number_text(in.controls.speed);
  if (const auto text = entry_.draw("##speed", shown, field)) {
    const Typed typed = read_typed("speed", Controls::kLeastSpeed, Controls::kGreatestSpeed, *text);
    if (const double* number = std::get_if<double>(&typed)) {
      in.controls.set_speed(*number);
      in.controls.refuse("", "");
    } else {
      in.controls.refuse("speed", std::get<std::string>(typed));
    }
  }
  in.events.widget("speed-field");
  in.tips.show("Times real time");
  ImGui::SameLine(0, gap);
  ImGui::TextDisabled("\u00d7");
}

void TransportPanel::draw_seed(float width, const PanelInput& in) {
  const Parameter& parameter = *find_parameter("seed");
  const float em = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float label = 2.6f * em, button_width = 3 * em;
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("seed");
  ImGui::SameLine(left + label);
  const std::string shown = format_value(parameter, in.controls.params);
  if (const auto text = entry_.draw("##seed", shown, width - label - button_width - gap)) {
    const Typed typed = read_typed(parameter, *text);
    if (const double* number = std::get_if<double>(&typed)) {
      in.controls.propose(parameter, *number);
    } else {
      in.controls.refuse("seed", std::get<std::string>(typed));
    }
  }
  in.events.widget("seed");
  in.tips.show("Fixes every random number. Type another and press Enter: the litter starts again.");
  ImGui::SameLine(0, gap);
  if (ImGui::Button("New", {button_width, 0})) in.controls.actions.push_back(Action::new_seed);
  in.events.widget("new_seed");
  in.tips.show("Start again with a random seed (Shift + R)");
}

}  // namespace pupflow::window
