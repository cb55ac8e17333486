#include "app/view/colormap.h"

#include <gmock/gmock.h>

#include <cmath>

#include "app/io/failure.h"

namespace pupflow::view {
namespace {

using ::testing::HasSubstr;

struct Entry {
  const char* map;
  std::size_t index;
  Rgb color;
};

// As published: the ends, quarters and middle that plotting programs print as hexadecimal colors.
TEST(Colormap, KnownEntries) {
  const Entry entries[] = {
      {"viridis", 0, {0x44, 0x01, 0x54}},   {"viridis", 64, {0x3b, 0x52, 0x8b}},
      {"viridis", 128, {0x21, 0x91, 0x8c}}, {"viridis", 192, {0x5e, 0xc9, 0x62}},
      {"viridis", 255, {0xfd, 0xe7, 0x25}}, {"inferno", 0, {0x00, 0x00, 0x04}},
      {"inferno", 128, {0xbc, 0x37, 0x54}}, {"inferno", 255, {0xfc, 0xff, 0xa4}},
      {"cividis", 0, {0x00, 0x22, 0x4e}},   {"cividis", 255, {0xfe, 0xe8, 0x38}},
      {"jet", 0, {0x00, 0x00, 0x80}},       {"jet", 255, {0x80, 0x00, 0x00}}};
  for (const Entry& entry : entries) {
    EXPECT_TRUE(find_colormap(entry.map)[entry.index] == entry.color)
        << entry.map << " " << entry.index;
  }
}

double lightness(Rgb color) {
  const auto linear = [](std::uint8_t byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(Colormap, PerceptualMapsGetLighterAllTheWay) {
  for (const char* name : {"viridis", "inferno", "cividis"}) {
    const Colormap map = find_colormap(name);
    for (std::size_t i = 1; i < map.size(); ++i) {
      EXPECT_GT(lightness(map[i]), lightness(map[i - 1]) - 0.35) << name << " " << i;
      if (i >= 4) {
        EXPECT_GT(lightness(map[i]), lightness(map[i - 4])) << name << " " << i;
      }
    }
    EXPECT_GT(lightness(map.back()) - lightness(map.front()), 70) << name;
  }
  const Colormap jet = find_colormap("jet");  // which is why it is no default
  EXPECT_LT(lightness(jet.back()), lightness(jet[128]));
}

TEST(Colormap, EveryNameIsFound) {
  EXPECT_THAT(colormap_names(),
              ::testing::ElementsAre("viridis", "inferno", "cividis", "jet", "bluered", "phase"));
  for (const auto name : colormap_names()) EXPECT_NO_THROW(find_colormap(name)) << name;
}

TEST(Colormap, UnknownNameIsBadInput) {
  try {
    find_colormap("rainbow");
    FAIL();
  } catch (const io::Failure& failure) {
    EXPECT_EQ(failure.code(), io::ExitCode::bad_input);
    EXPECT_THAT(failure.what(), HasSubstr("rainbow"));
    EXPECT_THAT(failure.what(), HasSubstr("viridis"));
  }
  try {
    find_colormap("virdis");
    FAIL();
  } catch (const io::Failure& failure) {
    EXPECT_THAT(failure.what(), HasSubstr("did you mean 'viridis'?"));
  }
}

TEST(Colormap, BlueredIsLightestInTheMiddleAndDarkensToBothSides) {
  const Colormap map = find_colormap("bluered");
  EXPECT_EQ(map.front(), (Rgb{5, 48, 97}));
  EXPECT_EQ(map.back(), (Rgb{103, 0, 31}));
  for (std::size_t i = 1; i < 128; ++i) {
    EXPECT_GE(lightness(map[i]), lightness(map[i - 1]) - 0.35) << i;
    EXPECT_GE(lightness(map[255 - i]), lightness(map[256 - i]) - 0.35) << i;
  }
}

TEST(Colormap, PhaseCloses) {
  const Colormap map = find_colormap("phase");
  const auto distance = [](Rgb a, Rgb b) {
    return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
  };
  EXPECT_LE(distance(map.front(), map.back()), 8);
  EXPECT_GT(distance(map[0], map[128]), 100);
}

TEST(Colormap, CategoriesDiffer) {
  for (std::size_t i = 0; i < kCategoryColors; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(category_colors()[i], category_colors()[j]);
    EXPECT_EQ(category_colors()[i], category_colors()[i + kCategoryColors]);
  }
}

}  // namespace
}  // namespace pupflow::view
