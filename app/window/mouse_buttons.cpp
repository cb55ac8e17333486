#include "app/window/mouse_buttons.h"

#include <cstddef>

namespace pupflow::window {
namespace {

constexpr double kDoubleClick = 0.3;  // seconds between two presses
constexpr double kAnyTime = 60;       // longer than any frame

bool same(const std::optional<ImVec2>& a, const std::optional<ImVec2>& b) {
  return a.has_value() == b.has_value() && (!a || (a->x == b->x && a->y == b->y));
}

}  // namespace

void MouseButtons::changed(int button, bool down, double time) {
  if (button < 0 || button >= ImGuiMouseButton_COUNT) return;
  double& before = pressed_at_[static_cast<std::size_t>(button)];
  const bool doubles = down && before >= 0 && time - before < kDoubleClick;
  if (down) before = time;
  changes_.push_back({button, down, doubles, place_});
}

void MouseButtons::apply(ImGuiIO& io) {
  io.MouseDoubleClickTime = static_cast<float>(kDoubleClick);
  std::array<bool, ImGuiMouseButton_COUNT> seen{};
  const auto place = changes_.empty() ? std::nullopt : changes_.front().place;
  if (place) io.MousePos = *place;
  while (!changes_.empty() && same(changes_.front().place, place)) {
    const Change change = changes_.front();
    const auto button = static_cast<std::size_t>(change.button);
    if (seen[button]) break;
    seen[button] = true;
    down_[button] = change.down;
    // Its frames may be further apart than the two presses.
    if (change.doubles) io.MouseDoubleClickTime = static_cast<float>(kAnyTime);
    changes_.pop_front();
  }
  for (std::size_t i = 0; i < down_.size(); ++i) io.MouseDown[i] = down_[i];
}

}  // namespace pupflow::window
