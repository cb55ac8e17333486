#include "app/window/panels/inspector_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "app/io/celsius.h"
#include "app/io/text.h"
#include "app/window/imgui_compat.h"
#include "app/window/session/parameter_text.h"

namespace pupflow::window {
namespace {

std::string shown(const Field& field, double value) {
  return std::isnan(value) ? "\u2013" : io::formatted("%.*f", field.digits, value);
}

/// A button that looks pressed while `on`.
bool toggle(const char* label, bool on, float width) {
  const ImVec4 color = ImGui::GetStyleColorVec4(on ? ImGuiCol_HeaderActive : ImGuiCol_Button);
  ImGui::PushStyleColor(ImGuiCol_Button, color);
  const bool pressed = ImGui::Button(label, {width, 0});
  ImGui::PopStyleColor();
  return pressed;
}

/// The label in the room that there is: with its symbol, alone, small, or else the symbol alone.
void draw_label(const PanelInput& in, const LitterField& field) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, em = ImGui::GetFontSize();
  const std::string label(field.label), symbol(field.symbol);
  const std::string both = titled(symbol, label);
  const auto fits = [&](const std::string& text) {
    return ImGui::CalcTextSize(text.c_str()).x <= room;
  };
  const ImVec2 small = small_text_size(in.fonts, label);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (fits(both)) {
    draw_rich_text(list, in.fonts, corner, kInk, both);
  } else if (fits(label)) {
    list.AddText(corner, kInk, label.c_str());
  } else if (small.x <= room || symbol.empty()) {
    small_text(list, in.fonts, {corner.x, corner.y + em - small.y}, kInk, label);
  } else {
    draw_rich_text(list, in.fonts, corner, kInk, symbol);
  }
  ImGui::Dummy({room, em});
}

/// On this line if there is room for a button of that width, else on the next.
void next_button(float width) {
  ImGui::SameLine();
  if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
}

}  // namespace

void InspectorPanel::draw(const PanelInput& in) {
  const LitterView litter = in.state.view();
  if (!in.controls.selected || *in.controls.selected >= litter.pups) return;
  const int pup = *in.controls.selected;
  bool kept = true;
  const std::string title = "pup " + std::to_string(pup) + "###inspector";
  const bool open = ImGui::CollapsingHeader(title.c_str(), &kept, ImGuiTreeNodeFlags_DefaultOpen);
  in.events.widget("inspector");
  if (!kept) in.controls.select({});
  if (!open || !kept) return;
  in.controls.inspected = recorded_for(map_.field());
  curves_.add(litter, pup);
  draw_buttons(in);
  draw_touches(in, pup);
  map_.draw(in, pup);
  draw_fields(in);
}

void InspectorPanel::draw_buttons(const PanelInput& in) const {
  const float gap = ImGui::GetStyle().ItemSpacing.x, room = ImGui::GetContentRegionAvail().x;
  const float small = ImGui::GetFrameHeight() + 0.5f * ImGui::GetFontSize();
  const float wide = (room - 2 * small - 3 * gap) / 2;
  const auto button = [&](const char* label, const char* name, Action action, float width,
                          bool on) {
    if (toggle(label, on, width)) in.controls.actions.push_back(action);
    in.events.widget(name);
    in.tips.show(std::string(key_row(action).doc) + " (" + key_row(action).text + ")");
  };
  button("<", "pup_before", Action::previous_pup, small, false);
  ImGui::SameLine();
  button(">", "pup_next", Action::next_pup, small, false);
  ImGui::SameLine();
  button("Follow", "follow", Action::follow_pup, wide,
         in.controls.camera_mode == CameraMode::follow);
  ImGui::SameLine();
  button("Pup's eye", "pups_eye", Action::pups_eye, wide,
         in.controls.camera_mode == CameraMode::eye);
}

void InspectorPanel::draw_touches(const PanelInput& in, int pup) const {
  const LitterView litter = in.state.view();
  if (litter.pups < 2) return;
  ImGui::AlignTextToFramePadding();
  if (!litter.recorded.has(Part::pairs)) {
    ImGui::TextDisabled("Whom it touches is known from the next step on.");
    return;
  }
  const std::vector<Touch> touches = touched_by(litter, pup);
  ImGui::TextUnformatted(touches.empty() ? "touches nobody" : "touches");
  for (const Touch& touch : touches) {
    const std::string number = std::to_string(touch.pup);
    const float least = ImGui::GetFrameHeight() + 0.5f * ImGui::GetFontSize();
    const float width =
        std::max(least, ImGui::CalcTextSize(number.c_str()).x + ImGui::GetFontSize());
    next_button(width);
    if (ImGui::Button((number + "##touch").c_str(), {width, 0})) in.controls.select(touch.pup);
    in.events.widget("touch-" + number);
    in.tips.show(io::formatted("%d of its %d points touch pup %d. Click to select that one.",
                               touch.points, litter.points, touch.pup));
  }
}

void InspectorPanel::draw_fields(const PanelInput& in) const {
  const float em = ImGui::GetFontSize();
  if (!ImGui::BeginTable("fields", 4)) return;
  ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("curve", ImGuiTableColumnFlags_WidthFixed, 2.6f * em);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, 3.1f * em);
  ImGui::TableSetupColumn("unit", ImGuiTableColumnFlags_WidthFixed, 2.8f * em);
  for (std::size_t i = 0; i < pup_fields().size(); ++i) {
    const LitterField& field = pup_fields()[i];
    const std::string text = shown(field, curves_.samples().back().values[i]);
    ImGui::TableNextColumn();
    draw_label(in, field);
    if (in.tips.begin()) {
      rich_text(in.fonts, kAccent, titled(field.symbol, field.label));
      ImGui::TextUnformatted(std::string(field.doc).c_str());
      if (!field.equation.empty()) ImGui::TextDisabled("%s", std::string(field.equation).c_str());
      const double value = curves_.samples().back().values[i];
      if (io::is_temperature(field) && std::isfinite(value)) {
        ImGui::TextDisabled("now %s", io::celsius_text(value).c_str());
      }
      in.tips.end();
    }
    ImGui::TableNextColumn();
    draw_curve(i);
    ImGui::TableNextColumn();
    right_text(text);
    ImGui::TableNextColumn();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.2f * em);
    push_font(in.fonts.small);
    ImGui::TextDisabled("%s", std::string(field.unit).c_str());
    ImGui::PopFont();
    if (!in.state.playing) in.events.field(field.name, text);
  }
  ImGui::EndTable();
}

/// As long as the pup was watched, between the least and the greatest value seen.
void InspectorPanel::draw_curve(std::size_t field) const {
  const auto& samples = curves_.samples();
  const float em = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, 0.9f * em};
  ImGui::Dummy(size);
  if (!ImGui::IsItemVisible()) return;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const PupCurves::Sample& sample : samples) {
    if (std::isnan(sample.values[field])) continue;
    low = std::min(low, sample.values[field]);
    high = std::max(high, sample.values[field]);
  }
  const double begin = samples.front().time, span = samples.back().time - begin;
  if (!(low <= high) || span <= 0) return;
  const bool turns = pup_fields()[field].kind == FieldKind::angle;
  const auto place = [&](const PupCurves::Sample& sample) {
    const double share = high > low ? (sample.values[field] - low) / (high - low) : 0.5;
    return ImVec2{corner.x + size.x * static_cast<float>((sample.time - begin) / span),
                  corner.y + size.y * static_cast<float>(1 - share)};
  };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double from = samples[i - 1].values[field], to = samples[i].values[field];
    if (std::isnan(from) || std::isnan(to)) continue;
    if (turns && std::abs(to - from) > std::numbers::pi) continue;  // from one end to the other
    list.AddLine(place(samples[i - 1]), place(samples[i]), kAccent, 0.08f * em);
  }
}

}  // namespace pupflow::window
