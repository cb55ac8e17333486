#include <gmock/gmock.h>

#include "app/window/panels/layout.h"

namespace pupflow::window {
namespace {

float end(const Area& area) {
  return area.corner.x + area.size.x;
}

TEST(Layout, FillsTheWindowFromLeftToRight) {
  for (const float width : {500.0f, 900.0f, 1400.0f, 3000.0f}) {
    for (const float scale : {1.0f, 1.25f, 1.5f, 2.0f}) {
      const Layout layout = make_layout(width, 900, scale, true);
      EXPECT_FLOAT_EQ(layout.arena.corner.x, end(layout.left));
      EXPECT_FLOAT_EQ(layout.bar.corner.x, end(layout.arena));
      EXPECT_FLOAT_EQ(layout.right.corner.x, end(layout.bar));
      EXPECT_FLOAT_EQ(end(layout.transport), end(layout.bar));
      EXPECT_FLOAT_EQ(end(layout.right), width);
      EXPECT_GT(layout.arena.size.x, 0.2f * width) << width << " at " << scale;
      EXPECT_EQ(layout.two_panels, layout.right.size.x > 0);
    }
  }
}

TEST(Layout, TheUsualWindowHasBothPanels) {
  EXPECT_TRUE(make_layout(1400, 900, 1, true).two_panels);
  EXPECT_FALSE(make_layout(1400, 900, 2, true).two_panels);
}

TEST(Layout, WithoutPanelsTheArenaHasItAll) {
  const Layout layout = make_layout(1400, 900, 1, false);
  EXPECT_EQ(layout.arena.corner.x, 0);
  EXPECT_FLOAT_EQ(end(layout.bar), 1400);
  EXPECT_FALSE(layout.two_panels);
}

}  // namespace
}  // namespace pupflow::window
