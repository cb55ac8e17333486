#include <gmock/gmock.h>

#include "app/window/panels/layout.h"

namespace pupflow::window {
namespace {

float end(const Area& area) {
  return area.corner.x + area.size.x;
}

float low(const Area& area) {
  return area.corner.y + area.size.y;
}

TEST(Layout, FillsTheWindowFromLeftToRight) {
  for (const float width : {360.0f, 500.0f, 800.0f, 900.0f, 1400.0f, 3000.0f}) {
    for (const float scale : {1.0f, 1.25f, 1.5f, 2.0f}) {
      const Layout layout = make_layout({.width = width, .height = 900, .scale = scale});
      EXPECT_FLOAT_EQ(layout.arena.corner.x, end(layout.left));
      EXPECT_FLOAT_EQ(layout.bar.corner.x, end(layout.arena));
      EXPECT_FLOAT_EQ(layout.right.corner.x, end(layout.bar));
      EXPECT_FLOAT_EQ(end(layout.transport), end(layout.bar));
      EXPECT_FLOAT_EQ(end(layout.right), width);
      EXPECT_GE(layout.arena.size.x, 0.2f * width) << width << " at " << scale;
      EXPECT_EQ(layout.two_panels, layout.right.size.x > 0);
    }
  }
}

TEST(Layout, FillsTheWindowFromTopToBottom) {
  for (const float height : {300.0f, 600.0f, 900.0f}) {
    for (const float transport : {50.0f, 120.0f, 400.0f}) {
      const Layout layout = make_layout({.width = 900, .height = height, .transport = transport});
      EXPECT_FLOAT_EQ(layout.arena.corner.y, low(layout.menu));
      EXPECT_FLOAT_EQ(layout.transport.corner.y, low(layout.arena));
      EXPECT_FLOAT_EQ(low(layout.transport), height);
      EXPECT_FLOAT_EQ(low(layout.left), height);
      EXPECT_GE(layout.arena.size.y, 0.4f * height);
    }
  }
}

TEST(Layout, TheTransportHasTheHeightThatItNeeds) {
  EXPECT_EQ(make_layout({.width = 900, .height = 600, .transport = 130}).transport.size.y, 130);
}

TEST(Layout, TheUsualWindowHasBothPanels) {
  EXPECT_TRUE(make_layout({.width = 1400, .height = 900}).two_panels);
  EXPECT_FALSE(make_layout({.width = 1400, .height = 900, .scale = 2}).two_panels);
}

TEST(Layout, WithoutPanelsTheArenaHasItAll) {
  const Layout layout = make_layout({.width = 1400, .height = 900, .panels = false});
  EXPECT_EQ(layout.arena.corner.x, 0);
  EXPECT_FLOAT_EQ(end(layout.bar), 1400);
  EXPECT_FALSE(layout.two_panels);
}

TEST(Layout, ASmallWindowStillHasItsPanelBesideTheArena) {
  const Layout layout = make_layout({.width = 800, .height = 600});
  EXPECT_FALSE(layout.narrow);
  EXPECT_GE(layout.left.size.x, 340);
  EXPECT_GT(layout.bar.size.x, 0);
}

TEST(Layout, TheDrawerOfANarrowWindowLiesOverTheArena) {
  LayoutWish wish{.width = 360, .height = 500};
  const Layout closed = make_layout(wish);
  EXPECT_TRUE(closed.narrow);
  EXPECT_EQ(closed.left.size.x, 0) << "though panels are wished for";
  wish.drawer = true;
  const Layout open = make_layout(wish);
  EXPECT_EQ(open.left.size.x, 360);
  EXPECT_FALSE(overlap(open.left, open.transport)) << "the run's buttons stay in reach";
  EXPECT_FALSE(overlap(open.left, open.menu)) << "and the button that closes it";
  EXPECT_EQ(open.arena.size.x, closed.arena.size.x) << "the arena stays where it is";
}

TEST(Layout, AWideWindowHasNoDrawer) {
  const Layout layout =
      make_layout({.width = 1400, .height = 900, .panels = false, .drawer = true});
  EXPECT_FALSE(layout.narrow);
  EXPECT_EQ(layout.left.size.x, 0);
}

TEST(Layout, TheLegendStepsAsideInANarrowOrLowWindow) {
  EXPECT_GT(make_layout({.width = 360, .height = 500}).bar.size.x, 0);
  EXPECT_EQ(make_layout({.width = 300, .height = 500}).bar.size.x, 0);
  EXPECT_EQ(make_layout({.width = 1400, .height = 220}).bar.size.x, 0);
}

}  // namespace
}  // namespace pupflow::window
