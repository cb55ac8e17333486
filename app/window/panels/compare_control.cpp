#include "app/window/panels/compare_control.h"

#include <imgui.h>

#include <algorithm>

#include "app/window/panel_text.h"
#include "app/window/panels/choice.h"
#include "app/window/panels/list_rows.h"
#include "app/window/session/parameter_text.h"
#include "app/window/typed_number.h"

namespace pupflow::window {
namespace {

constexpr const char* kPopup = "compare";

bool can_differ(const Parameter& parameter) {
  return parameter.effect != Parameter::Effect::run || parameter.name == "seed";
}

/// A button with rich text in its middle; what is too long is cut at its end.
bool rich_button(const Fonts& fonts, const char* id, const std::string& label, float width) {
  const bool pressed = ImGui::Button(id, {width, 0});
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  const float room = high.x - low.x - 2 * padding.x;
  const float rest = std::max(room - rich_text_width(fonts, label), 0.0f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(low, {high.x - padding.x, high.y}, true);
  draw_rich_text(list, fonts, {low.x + padding.x + rest / 2, low.y + padding.y},
                 ImGui::GetColorU32(ImGuiCol_Text), label);
  list.PopClipRect();
  return pressed;
}

}  // namespace

void CompareControl::draw(float width, const PanelInput& in) {
  std::string label = "Compare";
  if (in.state.second) {
    label = difference_text(in.state.view().params, in.state.second->view().params, 1);
  }
  const bool on = in.state.second.has_value();
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  if (rich_button(in.fonts, "##compare", label, width)) {
    problem_.clear();
    ImGui::OpenPopup(kPopup);
  }
  if (on) ImGui::PopStyleColor();
  in.events.widget("compare");
  if (!ImGui::BeginPopup(kPopup)) return;
  if (on) {
    draw_end(in);
  } else {
    draw_choice(in);
  }
  ImGui::EndPopup();
}

void CompareControl::draw_choice(const PanelInput& in) {
  const float width = 14 * ImGui::GetFontSize();
  ImGui::TextUnformatted("A second litter beside this one, the same but for");
  const Parameter* chosen = find_parameter(parameter_);
  window::draw_choice(
      "compare-parameter", chosen->title, "What is different in the second litter", in,
      [&](const auto& choice) {
        for (const Parameter& parameter : parameters()) {
          if (!can_differ(parameter)) continue;
          if (!choice(parameter.name, parameter.title, "", &parameter == chosen)) continue;
          parameter_ = parameter.name;
          value_.clear();
          problem_.clear();
        }
      },
      width);
  draw_value(*chosen, in);
  check_box("from now on", &from_now_);
  in.events.widget("compare-now");
  ImGui::SameLine();
  ImGui::TextDisabled(from_now_ ? "both go on from here" : "both begin at the start");
  if (ImGui::Button("Compare##start", {width, 0})) {
    Params with = in.controls.params;
    Problem problem;
    if (!parse_value(*chosen, value_, with, problem)) {
      problem_ = problem.message;
    } else if (with == in.controls.params) {
      problem_ = "That is the value of this litter.";
    } else if (const auto problems = check(with); !problems.empty()) {
      problem_ = problems.front().message;
    } else {
      in.controls.commands.push_back(Compare{with, from_now_});
      ImGui::CloseCurrentPopup();
    }
  }
  in.events.widget("compare-start");
  problem_line(problem_);
}

void CompareControl::draw_value(const Parameter& parameter, const PanelInput& in) {
  const float width = 14 * ImGui::GetFontSize();
  if (value_.empty()) value_ = format_value(parameter, in.controls.params);
  if (parameter.kind == Parameter::Kind::choice) {
    const std::string shown = value_;
    window::draw_choice(
        "compare-value", shown, "Its value there", in,
        [&](const auto& choice) {
          for (const std::string_view name : parameter.choices) {
            if (choice(name, name, "", name == shown)) value_ = name;
          }
        },
        width);
    return;
  }
  if (const auto text = entry_.draw("##value", value_, width)) {
    const Typed typed = read_typed(parameter, *text);
    const double* number = std::get_if<double>(&typed);
    problem_ = number ? "" : std::get<std::string>(typed);
    if (number) value_ = format_value(parameter, *number);
  }
  in.events.widget("compare-value");
  ImGui::SameLine();
  ImGui::TextDisabled("here %s", format_value(parameter, in.controls.params).c_str());
}

void CompareControl::draw_end(const PanelInput& in) {
  const LitterView here = in.state.view(), there = in.state.second->view();
  rich_text(in.fonts, kInk, difference_text(here.params, there.params));
  if (in.state.diverged_at) {
    ImGui::TextDisabled("They parted at step %lld.", static_cast<long long>(*in.state.diverged_at));
  } else {
    ImGui::TextDisabled("They have not parted yet.");
  }
  if (ImGui::Button("End the comparison")) {
    in.controls.commands.push_back(Compare{});
    ImGui::CloseCurrentPopup();
  }
  in.events.widget("compare-end");
}

}  // namespace pupflow::window
