#include "app/window/panels/tip.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pupflow::window {
namespace {

constexpr float kWidth = 28;  // the widest text, in em

bool same(const Area& a, const Area& b) {
  return a.corner.x == b.corner.x && a.corner.y == b.corner.y && a.size.x == b.size.x &&
         a.size.y == b.size.y;
}

bool any_button_down() {
  return ImGui::IsMouseDown(ImGuiMouseButton_Left) || ImGui::IsMouseDown(ImGuiMouseButton_Right) ||
         ImGui::IsMouseDown(ImGuiMouseButton_Middle);
}

Area item_area() {
  return {ImGui::GetItemRectMin(), ImGui::GetItemRectSize()};
}

}  // namespace

std::optional<ImVec2> tip_place(const Area& item, ImVec2 size, std::span<const Area> areas,
                                float gap) {
  std::optional<ImVec2> best;
  float least = 0;
  const std::array<ImVec2, 4> wishes{ImVec2{item.corner.x, item.corner.y + item.size.y + gap},
                                     ImVec2{item.corner.x, item.corner.y - gap - size.y},
                                     ImVec2{item.corner.x + item.size.x + gap, item.corner.y},
                                     ImVec2{item.corner.x - gap - size.x, item.corner.y}};
  for (const Area& area : areas) {
    if (size.x > area.size.x || size.y > area.size.y) continue;
    for (const ImVec2 wish : wishes) {
      const ImVec2 place{std::clamp(wish.x, area.corner.x, area.corner.x + area.size.x - size.x),
                         std::clamp(wish.y, area.corner.y, area.corner.y + area.size.y - size.y)};
      if (overlap({place, size}, item)) continue;
      const float distance =
          std::hypot(place.x - item.corner.x, place.y + size.y / 2 - item.middle().y);
      if (best && distance >= least) continue;
      best = place;
      least = distance;
    }
  }
  return best;
}

void Tips::begin_frame(const Layout& layout, double now) {
  now_ = now;
  due_.reset();
  shown_.reset();
  if (!seen_) item_.reset();
  seen_ = false;
  const Area lowest{{0, layout.transport.corner.y},
                    {ImGui::GetIO().DisplaySize.x, layout.transport.size.y}};
  areas_ = {layout.left, layout.right, layout.transport, layout.bar, lowest};
}

/// Whether the mouse has rested long enough on the item just submitted.
bool Tips::rests_here() {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return false;
  const Area item = item_area();
  if (!item_ || !same(*item_, item)) {
    item_ = item;
    pressed_ = open_ = false;
    size_ = {0, 0};
    resting_since_ = now_;
  }
  seen_ = true;
  if (any_button_down()) pressed_ = true;
  if (pressed_) return false;
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  if (!open_ && (moved.x != 0 || moved.y != 0)) resting_since_ = now_;
  open_ = open_ || now_ >= resting_since_ + kRest;
  if (!open_) due_ = resting_since_ + kRest;
  return open_;
}

bool Tips::begin() {
  if (!rests_here()) return false;
  const float em = ImGui::GetFontSize();
  const auto widest = std::max_element(areas_.begin(), areas_.end(),
                                       [](auto& a, auto& b) { return a.size.x < b.size.x; });
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  const float width = std::min(kWidth * em, widest->size.x - 2 * padding.x);
  const bool measured = size_.x > 0;
  const auto place = tip_place(*item_, size_, areas_, 0.3f * em);
  if (measured && !place) return false;
  if (measured) shown_ = Area{*place, size_};
  // Its size is known once it was submitted; until then it is out of sight.
  ImGui::SetNextWindowPos(measured ? *place : ImGui::GetIO().DisplaySize);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(padding.x + width);
  ImGui::BeginGroup();
  return true;
}

void Tips::end() {
  ImGui::EndGroup();
  ImGui::PopTextWrapPos();
  const ImVec2 padding = ImGui::GetStyle().WindowPadding, content = ImGui::GetItemRectSize();
  const ImVec2 size{content.x + 2 * padding.x, content.y + 2 * padding.y};
  if (size.x != size_.x || size.y != size_.y) due_ = now_;
  size_ = size;
  ImGui::EndTooltip();
}

void Tips::show(std::string_view text) {
  if (!begin()) return;
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  end();
}

}  // namespace pupflow::window
