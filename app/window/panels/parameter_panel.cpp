#include "app/window/panels/parameter_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace pupflow::window {
namespace {

constexpr std::array<std::string_view, 3> kTop{"ta", "alpha", "beta"};
constexpr const char* kRestarts = " \u21bb";  // an open circle arrow

bool on_top(const Parameter& parameter) {
  return std::count(kTop.begin(), kTop.end(), parameter.name) > 0;
}

/// The seed has a place of its own, and a window runs until it is closed.
bool in_groups(const Parameter& parameter) {
  return !on_top(parameter) && parameter.effect != Parameter::Effect::run &&
         parameter.name != "seed";
}

/// What a slider gives: three digits are as fine as its pixels. Typed values keep all of theirs.
double rounded(const Parameter& parameter, double value) {
  if (parameter.kind == Parameter::Kind::integer) return value;
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return std::strtod(text.data(), nullptr);
}

void propose_value(const Parameter& parameter, double value, const PanelInput& in) {
  Problem problem;
  if (!check_value(parameter, value, problem)) {
    in.controls.problem = problem.message;
    return;
  }
  Params candidate = in.controls.params;
  parameter.set(candidate, value);
  in.controls.propose(candidate);
}

void tooltip(const Parameter& parameter, const PanelInput& in) {
  if (!in.tips.begin()) return;
  std::string title(parameter.title);
  if (!parameter.symbol.empty()) title = std::string(parameter.symbol) + "  " + title;
  rich_text(in.fonts, kAccent, title);
  ImGui::TextUnformatted(parameter.doc.data(), parameter.doc.data() + parameter.doc.size());
  const auto line = [](const char* what, const std::string& text) {
    if (!text.empty()) ImGui::TextDisabled("%s: %s", what, text.c_str());
  };
  line("unit", std::string(parameter.unit));
  line("allowed", range_text(parameter));
  line("default", format_value(parameter, parameter.default_value()));
  line("source", std::string(parameter.source));
  line("set by", "--set " + std::string(parameter.name) + "=...");
  if (parameter.effect == Parameter::Effect::restart) {
    ImGui::TextUnformatted("A change restarts the litter.");
  }
  in.tips.end();
}

void choice(const Parameter& parameter, const PanelInput& in) {
  const std::string current = format_value(parameter, in.controls.params);
  if (!ImGui::BeginCombo("##value", current.c_str())) return;
  for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
    const std::string name(parameter.choices[i]);
    if (ImGui::Selectable(name.c_str(), name == current)) {
      propose_value(parameter, static_cast<double>(i), in);
    }
  }
  ImGui::EndCombo();
}

/// Three columns: symbol, value, title.
bool begin_rows(const char* id) {
  if (!ImGui::BeginTable(id, 3)) return false;
  const float em = ImGui::GetFontSize();
  ImGui::TableSetupColumn("symbol", ImGuiTableColumnFlags_WidthFixed, 3.4f * em);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("title", ImGuiTableColumnFlags_WidthFixed, 11.8f * em);
  return true;
}

}  // namespace

void ParameterPanel::draw_top(const PanelInput& in) {
  if (!begin_rows("top")) return;
  for (const std::string_view name : kTop) row(*find_parameter(name), in);
  ImGui::EndTable();
}

void ParameterPanel::draw_groups(const PanelInput& in) {
  const std::span<const Parameter> all = parameters();
  for (auto first = all.begin(); first != all.end(); ++first) {
    const auto same_group = [&](const Parameter& other) {
      return other.group == first->group && in_groups(other);
    };
    // A group is drawn where its first row stands; rows of one group need not be neighbours.
    if (!in_groups(*first) || std::any_of(all.begin(), first, same_group)) continue;
    const std::string group(first->group);
    const bool open =
        ImGui::CollapsingHeader(group.c_str(), group == "run" ? 0 : ImGuiTreeNodeFlags_DefaultOpen);
    in.events.widget("group-" + group);
    if (!open || !begin_rows(group.c_str())) continue;
    for (const Parameter& parameter : all) {
      if (same_group(parameter)) row(parameter, in);
    }
    ImGui::EndTable();
  }
}

void ParameterPanel::row(const Parameter& parameter, const PanelInput& in) {
  const std::string name(parameter.name);
  ImGui::PushID(name.c_str());
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  rich_text(in.fonts, kInk, parameter.symbol);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
  if (parameter.kind == Parameter::Kind::choice) {
    choice(parameter, in);
  } else {
    number(parameter, in);
  }
  in.events.widget(name);
  tooltip(parameter, in);
  ImGui::TableNextColumn();
  const bool changed = parameter.get(in.controls.params) != parameter.default_value();
  std::string title(parameter.title);
  if (parameter.effect == Parameter::Effect::restart) title += kRestarts;
  rich_text(in.fonts, changed ? kAccent : kFaint, title);
  tooltip(parameter, in);
  ImGui::PopID();
}

void ParameterPanel::number(const Parameter& parameter, const PanelInput& in) {
  const bool drafted = draft_ && draft_->parameter == &parameter;
  double value = drafted ? draft_->value : parameter.get(in.controls.params);
  const bool moved = slider(parameter, value);
  const bool active = ImGui::IsItemActive();
  const bool typing = active && ImGui::GetIO().WantTextInput;
  const bool done = ImGui::IsItemDeactivatedAfterEdit();
  if (moved) draft_ = Draft{&parameter, typing ? value : rounded(parameter, value)};
  if (!draft_ || draft_->parameter != &parameter) return;
  const bool at_once = parameter.effect == Parameter::Effect::next_step && !typing;
  if ((moved && at_once) || done) propose_value(parameter, draft_->value, in);
  if (!active) draft_.reset();
}

/// True when `value` was changed.
bool ParameterPanel::slider(const Parameter& parameter, double& value) const {
  const ImGuiSliderFlags flags =
      parameter.slider_log ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
  // A format without a conversion shows as it is and rounds nothing.
  std::string format = format_value(parameter, value);
  if (!parameter.unit.empty()) format += ' ' + std::string(parameter.unit);
  if (parameter.kind == Parameter::Kind::integer) {
    long long number = std::llround(value);
    const auto low = static_cast<long long>(parameter.slider_min);
    const auto high = static_cast<long long>(parameter.slider_max);
    const bool changed = ImGui::SliderScalar("##value", ImGuiDataType_S64, &number, &low, &high,
                                             format.c_str(), flags);
    value = static_cast<double>(number);
    return changed;
  }
  return ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &parameter.slider_min,
                             &parameter.slider_max, format.c_str(), flags);
}

}  // namespace pupflow::window
