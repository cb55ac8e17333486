#include "app/view/text.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/view/canvas.h"

namespace pupflow::view {
namespace {

constexpr Rgb kWhite{255, 255, 255}, kBlack{0, 0, 0};

io::Image paper(int width, int height) {
  io::Image image(width, height);
  fill(image, {0, 0, width, height}, kWhite);
  return image;
}

/// The smallest box around all ink.
Box ink(const io::Image& image) {
  int left = image.width, top = image.height, right = -1, bottom = -1;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (image.pixel(x, y)[0] > 200) continue;
      left = std::min(left, x), right = std::max(right, x);
      top = std::min(top, y), bottom = std::max(bottom, y);
    }
  }
  return {left, top, right - left + 1, bottom - top + 1};
}

Box drawn(const TextLine& line, double size) {
  io::Image image = paper(400, 200);
  TextPainter().draw(image, 100, 100, line, size, kBlack);
  return ink(image);
}

TEST(Text, StandsOnItsBaselineAtTheSizeAsked) {
  const Box letter = drawn({{"H"}}, 100);  // the capitals of DejaVu Sans are 0.729 em tall
  EXPECT_NEAR(letter.height, 73, 1);
  EXPECT_NEAR(letter.y + letter.height, 100, 1);
  EXPECT_GT(letter.x, 100);
}

TEST(Text, SubscriptIsSmallerAndLower) {
  const Box upright = drawn({{"x"}}, 100);
  const Box lowered = drawn({{"x", TextRun::Style::subscript}}, 100);
  EXPECT_NEAR(lowered.height, 0.72 * upright.height, 2);
  EXPECT_NEAR(lowered.y + lowered.height, upright.y + upright.height + 20, 2);
}

TEST(Text, ItalicLeansToTheRight) {
  const auto middle_of_row = [](const io::Image& image, int y) {
    double sum = 0, weight = 0;
    for (int x = 0; x < image.width; ++x) {
      const double dark = 255 - image.pixel(x, y)[0];
      sum += dark * x, weight += dark;
    }
    return sum / weight;
  };
  io::Image image = paper(200, 120);
  TextPainter().draw(image, 50, 100, {{"l", TextRun::Style::italic}}, 100, kBlack);
  EXPECT_NEAR(middle_of_row(image, 40) - middle_of_row(image, 90), 0.21 * 50, 2);
}

TEST(Text, AlignmentUsesTheWidth) {
  TextPainter text;
  const TextLine line = symbol("T", "a") + " = 0.25";
  const double width = text.width(line, 30);
  io::Image left = paper(300, 60), centre = paper(300, 60), right = paper(300, 60);
  text.draw(left, 150, 40, line, 30, kBlack, Align::left);
  text.draw(centre, 150, 40, line, 30, kBlack, Align::centre);
  text.draw(right, 150, 40, line, 30, kBlack, Align::right);
  EXPECT_NEAR(ink(left).x - ink(centre).x, width / 2, 1);
  EXPECT_NEAR(ink(left).x - ink(right).x, width, 1);
  EXPECT_LE(ink(right).x + ink(right).width, 151);
}

TEST(Text, ReadsUtf8) {
  TextPainter text;
  const double a = text.width({{"\u03b1"}}, 50);  // alpha: one letter, not two
  EXPECT_GT(a, 20);
  EXPECT_LT(a, 45);
  EXPECT_DOUBLE_EQ(text.width({{"\u03b1\u03b2"}}, 50), a + text.width({{"\u03b2"}}, 50));
  const double replacement = text.width({{"\uFFFD"}}, 50);
  for (const char* broken : {"\xff", "\xce", "\x80"}) {
    EXPECT_DOUBLE_EQ(text.width({{broken}}, 50), replacement);
  }
}

TEST(Text, TurnedTextReadsUpwards) {
  TextPainter text;
  io::Image flat = paper(200, 200), turned = paper(200, 200);
  const TextLine line{{"Flow"}};
  text.draw(flat, 100, 100, line, 40, kBlack, Align::centre);
  text.draw_upwards(turned, 100, 100, line, 40, kBlack);
  const Box a = ink(flat), b = ink(turned);
  EXPECT_NEAR(a.width, b.height, 1);
  EXPECT_NEAR(a.height, b.width, 1);
  EXPECT_LE(b.x + b.width, 102);  // the baseline is on the right
  // The F, with its bar at the top, comes first: at the bottom.
  int first_column = 0;
  for (int y = 0; y < 200; ++y) {
    if (turned.pixel(b.x + 2, y)[0] < 128) first_column = std::max(first_column, y);
  }
  EXPECT_GT(first_column, 100);
}

TEST(Text, OutsideThePictureNothingIsDrawn) {
  io::Image image = paper(20, 10);
  TextPainter text;
  text.draw(image, -300, -50, {{"far away"}}, 30, kBlack);
  EXPECT_EQ(ink(image).width, 0 - 20);
  EXPECT_NO_FATAL_FAILURE(text.draw(image, -5, 8, {{"wider than the picture"}}, 30, kBlack));
  EXPECT_GT(ink(image).width, 0);
}

}  // namespace
}  // namespace pupflow::view
