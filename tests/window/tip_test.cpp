#include "app/window/panels/tip.h"

#include <gmock/gmock.h>

#include <random>
#include <vector>

namespace pupflow::window {
namespace {

TEST(TipPlace, IsBelowTheItemWhereThereIsRoom) {
  const std::vector<Area> areas{{{0, 20}, {400, 800}}};
  const auto place = tip_place({{60, 100}, {170, 20}}, {300, 150}, areas, 4);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->x, 60);
  EXPECT_EQ(place->y, 124);
}

TEST(TipPlace, IsAboveAnItemAtTheBottom) {
  const std::vector<Area> areas{{{0, 20}, {400, 800}}};
  const auto place = tip_place({{60, 790}, {170, 20}}, {300, 150}, areas, 4);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->y, 790 - 4 - 150);
}

TEST(TipPlace, IsBesideAnItemInALowArea) {
  const std::vector<Area> areas{{{400, 800}, {600, 74}}};
  const auto place = tip_place({{420, 820}, {60, 20}}, {200, 50}, areas, 4);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->x, 484);
}

TEST(TipPlace, IsNowhereWhenNoAreaHoldsIt) {
  const std::vector<Area> areas{{{0, 0}, {100, 100}}, {{200, 0}, {300, 40}}};
  EXPECT_FALSE(tip_place({{0, 0}, {20, 20}}, {150, 60}, areas, 4));
}

TEST(TipPlace, IsWithinAnAreaAndNeverOverTheItem) {
  std::mt19937 random(1);
  const auto number = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  int placed = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Area> areas{{{0, 20}, {number(100, 500), number(100, 900)}},
                                  {{400, 800}, {number(100, 900), number(30, 200)}}};
    const Area item{{number(0, 900), number(0, 900)}, {number(10, 300), 20}};
    const ImVec2 size{number(20, 400), number(20, 200)};
    const auto place = tip_place(item, size, areas, 4);
    if (!place) continue;
    ++placed;
    EXPECT_FALSE(overlap({*place, size}, item));
    bool within = false;
    for (const Area& area : areas) {
      const float right = place->x + size.x, low = place->y + size.y;
      within = within || (place->x >= area.corner.x && place->y >= area.corner.y &&
                          right <= area.corner.x + area.size.x + 0.01f &&
                          low <= area.corner.y + area.size.y + 0.01f);
    }
    EXPECT_TRUE(within);
  }
  EXPECT_GT(placed, 500);
}

}  // namespace
}  // namespace pupflow::window
