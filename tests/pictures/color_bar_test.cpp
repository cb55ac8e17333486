#include "app/view/color_bar.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pupflow::view {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

constexpr Rgb kWhite{255, 255, 255};
constexpr Box kBar{60, 20, 30, 256};

io::Image bar_picture(const ColorScale& scale, double tp) {
  io::Image image(200, 300);
  fill(image, {0, 0, 200, 300}, kWhite);
  TextPainter text;
  const ColorBarStyle style;
  draw_color_bar(image, text,
                 lay_out_color_bar(kBar, color_bar_margins(scale, style), scale, tp, style),
                 style.ink);
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

TEST(ColorBar, MarksThePreferredTemperatureWhereItIsOrAtTheEndBeyondWhichItIs) {
  const ColorScale scale("viridis", 0, 1);
  const io::Image on = bar_picture(scale, 0.6), above = bar_picture(scale, 1.2),
                  below = bar_picture(scale, -0.3);
  const auto marked = [&](const io::Image& image, double share) {
    const int row = kBar.y + static_cast<int>(kBar.height * share);
    return has_ink(image, {0, std::max(row - 25, 0), kBar.x - 2, 50});
  };
  EXPECT_TRUE(marked(on, 0.4));
  EXPECT_FALSE(marked(on, 0.05));
  EXPECT_TRUE(marked(above, 0.05));
  EXPECT_FALSE(marked(above, 0.5));
  EXPECT_TRUE(marked(below, 0.95));
  EXPECT_FALSE(marked(below, 0.5));
  const int row = kBar.y + static_cast<int>(kBar.height * 0.4);
  EXPECT_NE(color_at(on, kBar.x + 15, row), color_at(above, kBar.x + 15, row));
}

TEST(ColorBar, TrianglesSayThatValuesLieBeyondTheEnds) {
  const Box over{kBar.x + 5, 0, kBar.width - 10, kBar.y - 2};
  const Box under{kBar.x + 5, kBar.y + kBar.height + 2, kBar.width - 10, 22};
  ColorScale scale("viridis", 0.2, 0.8);
  const io::Image inside = bar_picture(scale.fitted(std::vector{0.3, 0.7}), 0.5);
  EXPECT_FALSE(has_ink(inside, over));
  EXPECT_FALSE(has_ink(inside, under));
  const io::Image high = bar_picture(scale.fitted(std::vector{0.3, 0.9}), 0.5);
  EXPECT_TRUE(has_ink(high, over));
  EXPECT_FALSE(has_ink(high, under));
  const io::Image low = bar_picture(scale.fitted(std::vector{0.1, 0.7}), 0.5);
  EXPECT_FALSE(has_ink(low, over));
  EXPECT_TRUE(has_ink(low, under));
  EXPECT_EQ(color_at(low, kBar.x + 15, kBar.y + kBar.height + 4), scale.map.front());
}

TEST(ColorBar, StaysWithinItsMargins) {
  const ColorScale scale("viridis", 0, 1);
  const io::Image image = bar_picture(scale, 0.6);
  const ColorBarMargins margins = color_bar_margins(scale, {});
  EXPECT_FALSE(has_ink(image, {0, 0, kBar.x - margins.left, 300}));
  const int end = kBar.x + kBar.width + margins.right;
  EXPECT_TRUE(has_ink(image, {end - 24, 0, 24, 300}));  // the title
  EXPECT_FALSE(has_ink(image, {end, 0, 200 - end, 300}));
}

ColorBar layout_of(const ColorScale& scale) {
  return lay_out_color_bar(kBar, color_bar_margins(scale, {}), scale, 0.6, {});
}

ColorBar layout_of(const char* field, const std::vector<double>& values) {
  return layout_of(ColorScale(*find_field(field)).fitted(values));
}

std::string plain(const TextLine& line) {
  std::string text;
  for (const TextRun& run : line) text += run.text;
  return text;
}

std::vector<std::string> labels_of(const ColorBar& layout) {
  std::vector<std::string> labels;
  for (const ColorBar::Label& label : layout.labels) labels.push_back(plain(label.text));
  return labels;
}

TEST(ColorBarLayout, OfATemperatureMarksThePreferredOne) {
  const ColorBar layout = layout_of(ColorScale());
  EXPECT_EQ(layout.fills.size(), static_cast<std::size_t>(kBar.height));
  EXPECT_THAT(labels_of(layout),
              ElementsAre("0", "0.2", "0.4", "0.6", "0.8", "1", "Tp", "body temperature Tb"));
  EXPECT_TRUE(layout.labels.back().upwards);
  ASSERT_EQ(layout.triangles.size(), 1u);
  EXPECT_NEAR(layout.triangles[0].corners[0].y(), kBar.y + 0.4 * kBar.height, 1);
}

TEST(ColorBarLayout, OfAnotherFieldMarksNoTemperature) {
  const ColorBar layout = layout_of("exposed", {0.3});
  EXPECT_TRUE(layout.triangles.empty());
  EXPECT_EQ(labels_of(layout).back(), "exposed share A");
}

TEST(ColorBarLayout, OfASignedFieldHasALineAtItsCentre) {
  const ColorBar layout = layout_of("turn", {0.1});
  const double middle = kBar.y + kBar.height / 2.0;
  bool found = false;
  for (const ColorBar::Stroke& stroke : layout.strokes) {
    found = found || (stroke.x0 == kBar.x && std::abs(stroke.y0 - middle) <= 1);
  }
  EXPECT_TRUE(found);
  EXPECT_EQ(labels_of(layout).back(), "turn Δθ (rad/s)");
}

TEST(ColorBarLayout, OfAnAngleIsAWheelThatNamesPartsOfPi) {
  const ColorBar layout = layout_of("heading", {1});
  EXPECT_THAT(labels_of(layout),
              ElementsAre("0", "π/2", "π", "\u2212π/2", "direction of travel θ (rad)"));
  ASSERT_TRUE(layout.wheel);
  const ColorScale scale(*find_field("heading"));
  for (const double angle : {-3.0, -1.0, 0.0, 0.5, 2.0}) {
    EXPECT_EQ(wheel_color(*layout.wheel, angle), scale(angle));
  }
  io::Image image(200, 300);
  TextPainter text;
  draw_color_bar(image, text, layout, {0, 0, 0});
  const double r = (layout.wheel->inner + layout.wheel->outer) / 2;
  const auto at = [&](double angle) {
    return color_at(image, static_cast<int>(layout.wheel->centre.x() + r * std::cos(angle)),
                    static_cast<int>(layout.wheel->centre.y() - r * std::sin(angle)));
  };
  const auto distance = [](Rgb a, Rgb b) {
    return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
  };
  for (const double angle : {-1.5, 0.0, 1.5}) EXPECT_LT(distance(at(angle), scale(angle)), 30);
}

TEST(ColorBarLayout, OfCategoriesHasASwatchForEach) {
  const ColorBar side = layout_of("side", {0, 1});
  EXPECT_THAT(labels_of(side), ElementsAre("right", "left", "side"));
  ASSERT_EQ(side.fills.size(), 2u);
  EXPECT_EQ(side.fills[0].color, category_colors()[0]);
  EXPECT_LT(side.fills[0].box.y, side.fills[1].box.y);
  const ColorBar touched = layout_of("touched", {-1, 2});
  EXPECT_THAT(labels_of(touched), ElementsAre("nobody", "0", "1", "2", "touched pup"));
  EXPECT_EQ(touched.fills[0].color, kNobodyColor);
}

TEST(ColorBarLayout, SwatchesOfManyCategoriesStayWithinTheBar) {
  const ColorBar layout = layout_of("group", {0, 499});
  EXPECT_EQ(layout.fills.size(), static_cast<std::size_t>(kCategoryColors));
  for (const ColorBar::Fill& fill : layout.fills) {
    EXPECT_LE(fill.box.y + fill.box.height, kBar.y + kBar.height);
  }
  EXPECT_EQ(labels_of(layout).front(), "0, 12, \u2026");
}

TEST(ColorBarLayout, NamesTheColorOfUnknownValues) {
  const double nan = std::nan("");
  for (const char* field : {"group", "strain", "heading", "turn"}) {
    EXPECT_THAT(labels_of(layout_of(field, {0.5, nan})), Contains("unknown")) << field;
    EXPECT_THAT(labels_of(layout_of(field, {0.5})), Not(Contains("unknown"))) << field;
  }
}

TEST(ColorBarLayout, DegreesStandOnTheLeftOfATemperature) {
  const ColorBarStyle style{.celsius = true};
  const ColorScale tb("viridis", 0, 1), strain("viridis", 0, 1, *find_field("strain"));
  const ColorBar layout = lay_out_color_bar(kBar, color_bar_margins(tb, style), tb, 0.6, style);
  EXPECT_THAT(labels_of(layout), AllOf(Contains("0"), Contains("20"), Contains("60"),
                                       Contains("\u00b0C"), Contains("Tp")));
  EXPECT_THAT(labels_of(layout), Not(Contains("40"))) << "0.649, beside T_p";
  EXPECT_THAT(
      labels_of(lay_out_color_bar(kBar, color_bar_margins(strain, style), strain, 0.6, style)),
      Not(Contains("\u00b0C")));
  EXPECT_EQ(color_bar_margins(strain, style).left, color_bar_margins(strain, {}).left);
}

TEST(ColorBarLayout, DegreesKeepWithinTheMarginAndApart) {
  TextPainter text;
  for (const double size : {9.0, 16.0, 64.0}) {
    for (const auto& [low, high, tp] : {std::array{0.0, 1.0, 0.6}, std::array{0.55, 0.56, 0.6},
                                        std::array{-1.0, 2.0, -3.0}, std::array{0.2, 0.3, 0.21}}) {
      const ColorBarStyle style{.text_size = size, .celsius = true};
      const ColorScale scale("viridis", low, high);
      const ColorBarMargins margins = color_bar_margins(scale, style);
      const Box bar{margins.left, 2 * static_cast<int>(size), 20, static_cast<int>(16 * size)};
      double above = -1e9;
      std::vector<double> rows;
      for (const ColorBar::Label& label :
           lay_out_color_bar(bar, margins, scale, tp, style).labels) {
        if (label.align != Align::right) continue;
        EXPECT_GE(label.x - text.width(label.text, label.size), 0) << plain(label.text);
        rows.push_back(label.y);
      }
      std::ranges::sort(rows);
      for (const double row : rows) {
        EXPECT_GE(row - above, 0.8 * size) << size << " from " << low;
        above = row;
      }
      EXPECT_GE(rows.size(), 3u);
    }
  }
}

TEST(ColorBarLayout, TitleStandsWithinTheMarginsWhateverTheData) {
  for (const auto table : {pup_fields(), afferent_fields()}) {
    for (const LitterField& field : table) {
      const ColorScale scale(field);
      const int right = color_bar_margins(scale, {}).right;
      const ColorBar layout =
          lay_out_color_bar(kBar, color_bar_margins(scale, {}),
                            scale.fitted(std::vector<double>{0, 12345.678}), 0.6, {});
      EXPECT_LT(layout.labels.back().x, kBar.x + kBar.width + right) << field.name;
    }
  }
}

TEST(ColorBar, OfTheLargestNumbersIsDrawn) {
  const ColorScale scale("viridis", 0, 1.7e308);
  ColorBarStyle style;
  style.celsius = true;
  const ColorBar layout =
      lay_out_color_bar(kBar, color_bar_margins(scale, style), scale, 0.6, style);
  EXPECT_GT(layout.strokes.size(), 3u);
  for (const ColorBar::Stroke& stroke : layout.strokes) {
    EXPECT_GE(stroke.y0, kBar.y);
    EXPECT_LE(stroke.y0, kBar.y + kBar.height + 1);
  }
  EXPECT_TRUE(has_ink(bar_picture(scale, 0.6), kBar));
}

TEST(Canvas, DrawsNothingThatIsTooFarAway) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  io::Image image(64, 64);
  const io::Image before = image;
  for (const double far : {kInf, -kInf, std::nan(""), 1e300}) {
    line(image, 1, far, 5, far, 2, {});
    line(image, far, far, 5, 5, 2, {});
    line(image, Eigen::Vector2d(far, far), Eigen::Vector2d(far, far), 2, {}, 1);
    const std::array<Eigen::Vector2d, 3> corners{Eigen::Vector2d(1, far), Eigen::Vector2d(5, far),
                                                 Eigen::Vector2d(far, far)};
    fill(image, corners, {}, 1);
  }
  EXPECT_EQ(image.rgba, before.rgba);
}

}  // namespace
}  // namespace pupflow::view
