#include "app/window/panels/legend_panel.h"

#include <algorithm>
#include <string>

#include "app/io/celsius.h"
#include "app/io/failure.h"
#include "app/io/text.h"
#include "app/view/color_bar.h"
#include "app/window/panels/color_lists.h"
#include "app/window/panels/legend.h"
#include "app/window/typed_number.h"

namespace pupflow::window {
namespace {

constexpr ImGuiWindowFlags kStrip =
    kPanelWindow | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
constexpr float kBeyond = 0.95f;   // em beside either end: grips, and what says values lie beyond
constexpr float kUnknown = 2.5f;   // em below the bar for the values that are not known
constexpr float kBarWidth = 1.3f;  // em
constexpr float kEndWidth = 4.6f;  // em, of a typed end
constexpr float kPopupWidth = 11;  // em
constexpr float kDragStarts = 2;   // pixels from the press

const char* name_of(ScaleEnd end) {
  return end == ScaleEnd::high ? "scale_high" : "scale_low";
}

/// Beside the strip, where nothing moves for it.
void draw_problem(const Area& strip, const PanelInput& in) {
  const std::string& at = in.controls.problem_at;
  if (in.controls.problem.empty() || (!at.starts_with("scale_") && at != "trail")) return;
  ImGui::SetNextWindowPos({strip.corner.x, strip.corner.y}, ImGuiCond_Always, {1, 0});
  ImGui::Begin("legend problem", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  colored_text(kBad, in.controls.problem);
  ImGui::End();
}

}  // namespace

void LegendPanel::draw(const Area& strip, const view::ColorScale& fitted, const PanelInput& in) {
  in.controls.colors_in_strip = false;
  if (strip.size.x < kLeastLegendWidth || strip.size.y < kLeastLegendHeight) return;
  if (!in.controls.panels) {
    draw_bare_legend(strip, fitted, in.state.view().params.preferred_temperature);
    return;
  }
  const float em = ImGui::GetFontSize(), margin = 0.45f * em;
  ImGui::SetNextWindowPos(strip.corner);
  ImGui::SetNextWindowSize(strip.size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {margin, margin});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.3f * em, ImGui::GetStyle().FramePadding.y});
  ImGui::Begin("legend", nullptr, kStrip);
  const view::ColorScale& scale = in.controls.look.scale;
  const bool ends = ends_apply(scale, view::Ends::automatic);
  const LegendPlan plan = plan_legend({.height = strip.size.y - 2 * margin,
                                       .em = em,
                                       .row = ImGui::GetFrameHeightWithSpacing(),
                                       .maps = (ends ? 1 : 0) + (scale.categorical() ? 0 : 1),
                                       .has_ends = ends,
                                       .section = 1 + OverlayMenu::lines(),
                                       .least_bar = least_bar(scale),
                                       .usual = usual_bar(scale)});
  if (plan.field) draw_field_list(in);
  if (plan.lists) draw_scale_lists(in);
  in.controls.colors_in_strip = plan.field && plan.lists;
  if (plan.ends) draw_end(ScaleEnd::high, fitted, in);
  draw_bar(plan.bar, fitted, ends, in);
  if (plan.ends) draw_end(ScaleEnd::low, fitted, in);
  draw_section(plan, in);
  ImGui::End();
  ImGui::PopStyleVar(3);
  draw_problem(strip, in);
}

void LegendPanel::draw_bar(float height, const view::ColorScale& fitted, bool ends,
                           const PanelInput& in) {
  const float em = ImGui::GetFontSize(), room = ImGui::GetContentRegionAvail().x;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  view::ColorBarStyle style{.text_size = static_cast<double>(em), .titled = false};
  const auto width = [&] {
    const view::ColorBarMargins margins = view::color_bar_margins(fitted, style);
    return static_cast<float>(margins.left + margins.right + kBarWidth * style.text_size);
  };
  style.text_size *= static_cast<double>(std::min(1.0f, room / width()));
  const view::ColorBarMargins margins = view::color_bar_margins(fitted, style);
  const float beyond = ends ? kBeyond * em : 0.3f * em;
  const float unknown = fitted.unknown ? kUnknown * em : 0;
  const Area bar{
      {corner.x + std::max(0.0f, (room - width()) / 2) + static_cast<float>(margins.left),
       corner.y + beyond},
      {kBarWidth * static_cast<float>(style.text_size),
       std::max(1.0f, height - 2 * beyond - unknown)}};
  const view::Box box{static_cast<int>(bar.corner.x), static_cast<int>(bar.corner.y),
                      static_cast<int>(bar.size.x), static_cast<int>(bar.size.y)};
  paint_legend(*ImGui::GetWindowDrawList(),
               view::lay_out_color_bar(box, margins, fitted,
                                       in.state.view().params.preferred_temperature, style),
               kInk, kFaint);
  if (ends) {
    draw_grip(ScaleEnd::high, bar, fitted, in);
    draw_grip(ScaleEnd::low, bar, fitted, in);
  }
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy({room, height - ImGui::GetStyle().ItemSpacing.y});
}

/// The end as text, in the middle of the strip.
void LegendPanel::draw_end(ScaleEnd end, const view::ColorScale& fitted, const PanelInput& in) {
  const float room = ImGui::GetContentRegionAvail().x;
  const float width = std::min(room, kEndWidth * ImGui::GetFontSize());
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + (room - width) / 2);
  const double value = end == ScaleEnd::high ? fitted.max : fitted.min;
  const std::string shown = fitted.ends == view::Ends::typed
                                ? io::number_text(value)
                                : end_text(value, fitted.min, fitted.max);
  const char* const name = name_of(end);
  const auto typed = text_.draw((std::string("##") + name).c_str(), shown, width);
  in.events.widget(name);
  std::string tip = end == ScaleEnd::high ? "The value at the upper end: type it, or drag the end"
                                          : "The value at the lower end: type it, or drag the end";
  if (fitted.is_temperature()) tip += "\nnow " + io::celsius_text(value) + "; 0.6 is 37 \u00b0C";
  in.tips.show(tip);
  if (!typed) return;
  const Typed read = read_typed(*typed);
  if (const auto* reason = std::get_if<std::string>(&read)) {
    in.controls.refuse(name, *reason);
    return;
  }
  try {
    view::ColorScale& scale = in.controls.look.scale;
    scale = with_end(scale, fitted, end, std::get<double>(read));
    in.controls.problem.clear();
  } catch (const io::Failure& failure) {
    in.controls.refuse(name, failure.what());
  }
}

void LegendPanel::draw_grip(ScaleEnd end, const Area& bar, const view::ColorScale& fitted,
                            const PanelInput& in) {
  const float em = ImGui::GetFontSize(), half = 0.86f * em, out = 0.35f * em;
  const float y = end == ScaleEnd::high ? bar.corner.y : bar.corner.y + bar.size.y;
  const std::string name = std::string(name_of(end)) + "_grip";
  ImGui::SetCursorScreenPos({bar.corner.x - out, y - half});
  ImGui::InvisibleButton(name.c_str(), {bar.size.x + 2 * out, 2 * half});
  in.events.widget(name);
  in.tips.show("Drag: other values at the end of the colors. Double click: type one.");
  const bool held = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  if (held || hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  const float mouse = ImGui::GetIO().MousePos.y;
  if (ImGui::IsItemActivated()) {
    drag_ = EndDrag{end, fitted.min, fitted.max, static_cast<double>(bar.size.y),
                    static_cast<double>(mouse)};
  }
  if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    text_.focus((std::string("##") + name_of(end)).c_str());
  } else if (held && drag_ && ImGui::IsMouseDragging(ImGuiMouseButton_Left, kDragStarts)) {
    view::ColorScale& scale = in.controls.look.scale;
    scale = with_end(scale, fitted, end, drag_->value_at(static_cast<double>(mouse)));
  }
  const float reach = 0.17f * em;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low{bar.corner.x - out, y - reach}, high{bar.corner.x + bar.size.x + out, y + reach};
  list.AddRectFilled(low, high, held || hovered ? kAccent : ImGui::GetColorU32(ImGuiCol_WindowBg),
                     reach);
  list.AddRect(low, high, held || hovered ? kAccent : kFaint, reach);
}

void LegendPanel::draw_section(const LegendPlan& plan, const PanelInput& in) {
  if (plan.section) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("overlays");
    overlays_.draw(in);
    return;
  }
  if (!plan.button) return;
  if (ImGui::Button(plan.lists ? "Overlays \u2026" : "More \u2026", {-FLT_MIN, 0})) {
    ImGui::OpenPopup("overlays");
  }
  in.events.widget("overlays");
  in.tips.show("What is drawn over the litter, and how the litter is drawn");
  const float width = kPopupWidth * ImGui::GetFontSize();
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, FLT_MAX});
  if (!ImGui::BeginPopup("overlays")) return;
  if (!plan.lists) draw_scale_lists(in);
  overlays_.draw(in);
  ImGui::EndPopup();
}

}  // namespace pupflow::window
