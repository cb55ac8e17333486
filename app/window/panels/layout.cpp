#include "app/window/panels/layout.h"

#include <algorithm>

#include "app/window/panels/legend_plan.h"

namespace pupflow::window {
namespace {

constexpr float kLeftWidth = 424, kRightWidth = 290, kLeastArena = 400;
constexpr float kMenuHeight = 24, kTransportHeight = 74;

}  // namespace

Layout make_layout(float width, float height, float scale, bool panels) {
  Layout layout;
  const float left = panels ? std::min(kLeftWidth * scale, 0.6f * width) : 0;
  const float right = kRightWidth * scale;
  const float top = kMenuHeight * scale, low = kTransportHeight * scale;
  layout.two_panels = panels && width >= left + right + kLeastArena * scale;
  const float arena_end = layout.two_panels ? width - right : width;
  const float bar = std::min(kLegendWidth * scale, 0.3f * (arena_end - left));
  const float between = std::max(height - top - low, 1.0f);
  layout.menu = {{0, 0}, {width, top}};
  layout.left = {{0, top}, {left, height - top}};
  layout.arena = {{left, top}, {arena_end - left - bar, between}};
  layout.bar = {{arena_end - bar, top}, {bar, between}};
  layout.transport = {{left, top + between}, {arena_end - left, low}};
  layout.right = {{arena_end, top}, {width - arena_end, height - top}};
  return layout;
}

}  // namespace pupflow::window
