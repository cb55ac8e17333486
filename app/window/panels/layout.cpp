#include "app/window/panels/layout.h"

#include <algorithm>

#include "app/window/panels/legend_plan.h"

namespace pupflow::window {
namespace {

// At scale 1.
constexpr float kLeftWidth = 440, kLeastLeft = 400, kRightWidth = 290;
constexpr float kLeastArena = 400;                           // beside two panels, with the legend
constexpr float kLeastBeside = 320;                          // beside one panel, with the legend
constexpr float kLeastWithBar = 210, kLeastBarHeight = 150;  // arena beside the legend; its height
constexpr float kLeastDrawer = 200;                          // height

constexpr float kLeftShare = 0.45f;       // of the width, between kLeastLeft and kLeftWidth
constexpr float kTransportShare = 0.45f;  // of the height, at most

}  // namespace

Layout make_layout(const LayoutWish& wish) {
  const float scale = wish.scale, width = wish.width, height = wish.height;
  Layout layout;
  const float beside = std::clamp(kLeftShare * width, kLeastLeft * scale, kLeftWidth * scale);
  layout.narrow = width - beside < kLeastBeside * scale;
  const float left = layout.narrow || !wish.panels ? 0 : beside;
  const float right = kRightWidth * scale;
  layout.two_panels = left > 0 && width >= left + right + kLeastArena * scale;
  const float top = std::min(wish.menu, height);
  const float low = std::min(wish.transport, kTransportShare * height);
  const float between = std::max(height - top - low, 1.0f);
  const float arena_end = layout.two_panels ? width - right : width;
  const bool legend = arena_end - left >= (kLeastWithBar + kLegendWidth) * scale &&
                      between >= kLeastBarHeight * scale;
  const float bar = legend ? kLegendWidth * scale : 0;
  layout.menu = {{0, 0}, {width, top}};
  layout.left = {{0, top}, {left, height - top}};
  layout.arena = {{left, top}, {arena_end - left - bar, between}};
  layout.bar = {{arena_end - bar, top}, {bar, between}};
  layout.transport = {{left, top + between}, {arena_end - left, low}};
  layout.right = {{arena_end, top}, {width - arena_end, height - top}};
  if (layout.narrow && wish.drawer) {
    layout.left.size = {std::min(kLeftWidth * scale, width),
                        between < kLeastDrawer * scale ? height - top : between};
  }
  return layout;
}

}  // namespace pupflow::window
