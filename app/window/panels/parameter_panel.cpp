#include "app/window/panels/parameter_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "app/io/celsius.h"
#include "app/window/imgui_compat.h"
#include "app/window/panels/list_rows.h"
#include "app/window/panels/resets.h"
#include "app/window/session/parameter_text.h"
#include "app/window/typed_number.h"

namespace pupflow::window {
namespace {

constexpr std::array<std::string_view, 3> kTop{"ta", "alpha", "beta"};
constexpr std::string_view kPresetOf = "ta";
constexpr const char* kField = "##field";
constexpr float kFieldWidth = 4.8f, kTitleWidth = 13;  // em
constexpr float kLeastOthers = 16;                     // em; symbol, slider and field
constexpr const char* kRestarts = " \u21bb";           // an open circle arrow

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

void tooltip(const Parameter& parameter, const PanelInput& in) {
  if (!in.tips.begin()) return;
  rich_text(in.fonts, kAccent, titled(parameter.symbol, parameter.title));
  ImGui::TextUnformatted(parameter.doc.data(), parameter.doc.data() + parameter.doc.size());
  const auto line = [](const char* what, const std::string& text) {
    if (!text.empty()) ImGui::TextDisabled("%s: %s", what, text.c_str());
  };
  if (io::is_temperature(parameter)) {
    line("now", io::celsius_text(parameter.get(in.controls.params)) + "; 0.6 is 37 \u00b0C");
  }
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
  list_rows([&] {
    for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
      const std::string name(parameter.choices[i]);
      if (ImGui::Selectable(name.c_str(), name == current)) {
        in.controls.propose(parameter, static_cast<double>(i));
      }
      in.events.widget(std::string(parameter.name) + '-' + name);
    }
  });
  ImGui::EndCombo();
}

/// A slider without a number: that stands in the field beside it. True when `value` was changed.
bool slider(const Parameter& parameter, double& value) {
  const ImGuiSliderFlags flags =
      ImGuiSliderFlags_NoInput | (parameter.slider_log ? ImGuiSliderFlags_Logarithmic : 0);
  const char* const format = " ";  // without a conversion it rounds nothing
  if (parameter.kind == Parameter::Kind::integer) {
    long long number = std::llround(value);
    const auto low = static_cast<long long>(parameter.slider_min);
    const auto high = static_cast<long long>(parameter.slider_max);
    const bool changed =
        ImGui::SliderScalar("##slider", ImGuiDataType_S64, &number, &low, &high, format, flags);
    value = static_cast<double>(number);
    return changed;
  }
  return ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &parameter.slider_min,
                             &parameter.slider_max, format, flags);
}

/// How long it may take until a click that began at `time` turns out to be a double click; 0: it is
/// none, or a drag.
double rest_of_click(double time) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool drags = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] >
                     io.MouseDragThreshold * io.MouseDragThreshold;
  const double end = time + static_cast<double>(io.MouseDoubleClickTime);
  return drags ? 0 : std::max(0.0, end - ImGui::GetTime());
}

/// The title, which is a button for the parameter's menu, or why its last value was not taken.
bool draw_title(const Parameter& parameter, const PanelInput& in) {
  const bool refused = in.controls.problem_at == parameter.name;
  const bool changed = parameter.get(in.controls.params) != parameter.default_value();
  std::string text(parameter.title);
  if (parameter.effect == Parameter::Effect::restart) text += kRestarts;
  if (refused) text = "takes " + range_text(parameter);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight()};
  const bool pressed = ImGui::InvisibleButton("title", size);
  in.events.widget(std::string(parameter.name) + "-menu");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  if (ImGui::IsItemHovered()) {
    list.AddRectFilled(corner, end, ImGui::GetColorU32(ImGuiCol_HeaderHovered),
                       ImGui::GetStyle().FrameRounding);
  }
  const float em = ImGui::GetFontSize(), margin = 0.2f * em, between = 0.6f * em;
  const float y = corner.y + ImGui::GetStyle().FramePadding.y;
  // Small where there is no room, and the unit only where there is.
  Fonts fonts = in.fonts;
  const bool small = rich_text_width(fonts, text) + margin > size.x;
  if (small) fonts.text = fonts.small;
  const float drop = small ? em - small_text_size(in.fonts, text).y : 0;
  ImGui::PushClipRect(corner, end, true);
  const float width = draw_rich_text(list, fonts, {corner.x + margin, y + drop},
                                     refused   ? kBad
                                     : changed ? kAccent
                                               : kInk,
                                     text);
  const float unit = margin + width + between;
  if (!refused && unit + rich_text_width(in.fonts, parameter.unit) <= size.x) {
    draw_rich_text(list, in.fonts, {corner.x + unit, y}, kFaint, parameter.unit);
  }
  ImGui::PopClipRect();
  return pressed;
}

/// Three columns: symbol, value, title.
bool begin_rows(const char* id) {
  if (!ImGui::BeginTable(id, 3)) return false;
  const float em = ImGui::GetFontSize();
  // A narrow panel takes from the titles, which tooltips repeat, and not from the sliders.
  const float title =
      std::clamp(ImGui::GetContentRegionAvail().x - kLeastOthers * em, 5 * em, kTitleWidth * em);
  ImGui::TableSetupColumn("symbol", ImGuiTableColumnFlags_WidthFixed, 3 * em);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("title", ImGuiTableColumnFlags_WidthFixed, title);
  return true;
}

}  // namespace

void ParameterPanel::draw_top(const PanelInput& in) {
  if (!begin_rows("top")) return;
  for (const std::string_view name : kTop) {
    const Parameter& parameter = *find_parameter(name);
    row(parameter, in);
    if (name == kPresetOf) draw_presets(parameter, in);
  }
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
  draw_resets(in);
}

void ParameterPanel::row(const Parameter& parameter, const PanelInput& in) {
  const std::string name(parameter.name);
  bool right_click = false;
  const auto item = [&] {
    right_click |= ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Right);
    tooltip(parameter, in);
  };
  ImGui::PushID(name.c_str());
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  // Before the field, which can then take the keyboard in this frame: none may follow soon.
  if (menu_.draw(parameter, in)) entry_.focus(kField);
  rich_text(in.fonts, kInk, parameter.symbol);
  ImGui::TableNextColumn();
  if (parameter.kind == Parameter::Kind::choice) {
    ImGui::SetNextItemWidth(-1);
    choice(parameter, in);
    in.events.widget(name);
    item();
  } else {
    const float field = kFieldWidth * ImGui::GetFontSize();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    slide(parameter, ImGui::GetContentRegionAvail().x - field - gap, in);
    item();
    ImGui::SameLine(0, gap);
    type(parameter, field, in);
    item();
  }
  ImGui::TableNextColumn();
  const bool pressed = draw_title(parameter, in);
  item();
  if (pressed || right_click) menu_.open(parameter, in);
  ImGui::PopID();
}

/// A drag is proposed piece by piece where each piece acts at once, and undone as a whole. A double
/// click types: what its first click did is taken back.
void ParameterPanel::slide(const Parameter& parameter, float width, const PanelInput& in) {
  const bool drafted = draft_ && draft_->parameter == &parameter;
  double value = drafted ? draft_->value : parameter.get(in.controls.params);
  ImGui::SetNextItemWidth(width);
  const bool slid = slider(parameter, value);
  in.events.widget(parameter.name);
  const bool active = ImGui::IsItemActive();
  if (ImGui::IsItemActivated() && !double_clicked()) {
    pressed_ = {&parameter, parameter.get(in.controls.params), ImGui::GetTime()};
  }
  if (asks_to_type()) begin_typing(parameter, in);
  if (typing_ == &parameter) {
    if (!active) typing_ = nullptr;
    return;
  }
  if (slid) {
    const bool continues = drafted && draft_->proposed;
    draft_ = Draft{&parameter, rounded(parameter, value), continues};
    if (parameter.effect == Parameter::Effect::next_step) {
      in.controls.propose(parameter, draft_->value, continues);
      draft_->proposed = true;
    }
  }
  if (!draft_ || draft_->parameter != &parameter || active) return;
  if (!draft_->proposed) {
    if (const double rest = rest_of_click(pressed_.time); rest > 0) {
      in.controls.wake_in = rest;
      return;
    }
    in.controls.propose(parameter, draft_->value);
  }
  draft_.reset();
}

void ParameterPanel::begin_typing(const Parameter& parameter, const PanelInput& in) {
  entry_.focus(kField);
  typing_ = &parameter;
  draft_.reset();
  if (double_clicked() && pressed_.parameter == &parameter) {
    in.controls.propose(parameter, pressed_.value, true);
  }
}

void ParameterPanel::type(const Parameter& parameter, float width, const PanelInput& in) {
  const bool drafted = draft_ && draft_->parameter == &parameter;
  const double value = drafted ? draft_->value : parameter.get(in.controls.params);
  const auto text = entry_.draw(kField, format_value(parameter, value), width);
  in.events.widget(std::string(parameter.name) + "-field");
  if (!text) return;
  const Typed typed = read_typed(parameter, *text);
  if (const double* number = std::get_if<double>(&typed)) {
    in.controls.propose(parameter, *number);
  } else {
    in.controls.refuse(parameter.name, std::get<std::string>(typed));
  }
}

}  // namespace pupflow::window
