#include "app/view/color_bar.h"

#include <gmock/gmock.h>

namespace pupflow::view {
namespace {

using ::testing::DoubleNear;
using ::testing::Pointwise;

constexpr Rgb kWhite{255, 255, 255};
constexpr Box kBar{60, 20, 30, 256};

io::Image bar_picture(const ColorScale& scale, double tp) {
  io::Image image(200, 300);
  fill(image, {0, 0, 200, 300}, kWhite);
  TextPainter text;
  draw_color_bar(image, text, kBar, scale, tp, {});
  return image;
}

Rgb color_at(const io::Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return {p[0], p[1], p[2]};
}

/// Whether any pixel of `box` is not white.
bool has_ink(const io::Image& image, const Box& box) {
  for (int y = box.y; y < box.y + box.height; ++y) {
    for (int x = box.x; x < box.x + box.width; ++x) {
      if (color_at(image, x, y) != kWhite) return true;
    }
  }
  return false;
}

TEST(Ticks, AreRoundAndWithinTheScale) {
  const auto near = [](const std::vector<double>& values) {
    return Pointwise(DoubleNear(1e-12), values);
  };
  EXPECT_THAT(round_ticks(0, 1, 5), near({0, 0.2, 0.4, 0.6, 0.8, 1}));
  EXPECT_THAT(round_ticks(0.25, 0.71, 5), near({0.3, 0.4, 0.5, 0.6, 0.7}));
  EXPECT_THAT(round_ticks(-1, 2, 5), near({-1, 0, 1, 2}));
  EXPECT_THAT(round_ticks(0, 2500, 5), near({0, 500, 1000, 1500, 2000, 2500}));
}

TEST(Ticks, LabelsAreShort) {
  EXPECT_EQ(tick_label(3 * 0.2), "0.6");
  EXPECT_EQ(tick_label(-1), "\u22121");
  EXPECT_EQ(tick_label(0), "0");
}

TEST(ColorBar, ShowsTheMapFromBottomToTop) {
  const ColorScale scale("viridis", 0, 1);
  const io::Image image = bar_picture(scale, 5);
  for (int row = 0; row < kBar.height; ++row) {
    EXPECT_EQ(color_at(image, kBar.x + 15, kBar.y + row),
              scale.map[static_cast<std::size_t>(255 - row)]);
  }
}

TEST(ColorBar, MarksThePreferredTemperatureOnlyOnTheScale) {
  const ColorScale scale("viridis", 0, 1);
  const io::Image with = bar_picture(scale, 0.6), without = bar_picture(scale, 1.2);
  const Box left{0, 0, kBar.x - 2, 300};
  EXPECT_TRUE(has_ink(with, left));
  EXPECT_FALSE(has_ink(without, left));
  const int row = kBar.y + static_cast<int>(kBar.height * 0.4);
  EXPECT_NE(color_at(with, kBar.x + 15, row), color_at(without, kBar.x + 15, row));
}

TEST(ColorBar, StaysWithinItsMargins) {
  const ColorScale scale("viridis", 0, 1);
  const io::Image image = bar_picture(scale, 0.6);
  const ColorBarMargins margins = color_bar_margins({});
  EXPECT_FALSE(has_ink(image, {0, 0, kBar.x - margins.left, 300}));
  const int end = kBar.x + kBar.width + margins.right;
  EXPECT_TRUE(has_ink(image, {end - 24, 0, 24, 300}));  // the title
  EXPECT_FALSE(has_ink(image, {end, 0, 200 - end, 300}));
}

}  // namespace
}  // namespace pupflow::view
