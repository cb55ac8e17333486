#include "app/view/colormap.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "app/io/failure.h"

namespace pupflow::view {
namespace {

using ::testing::HasSubstr;

struct Entry {
  const char* map;
  std::size_t index;
  Rgb color;
};

// As published: the ends, quarters and middle that plotting programs print as hexadecimal colours.
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
  EXPECT_THAT(colormap_names(), ::testing::ElementsAre("viridis", "inferno", "cividis", "jet"));
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
}

TEST(ColorScale, SpreadsTheMapOverTheScale) {
  const ColorScale scale("inferno", -1, 3);
  EXPECT_EQ(scale(-1), scale.map[0]);
  EXPECT_EQ(scale(1), scale.map[128]);
  EXPECT_EQ(scale(2.9999), scale.map[255]);
  EXPECT_EQ(scale(3), scale.map[255]);
}

TEST(ColorScale, OutsideTakesTheNearerEnd) {
  const ColorScale scale("viridis", 0, 1);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(scale(-5), scale.map.front());
  EXPECT_EQ(scale(-infinity), scale.map.front());
  EXPECT_EQ(scale(7), scale.map.back());
  EXPECT_EQ(scale(infinity), scale.map.back());
  EXPECT_EQ(scale(std::nan("")), scale.map.front());
}

TEST(ColorScale, NeedsAnInterval) {
  EXPECT_THROW(ColorScale("viridis", 1, 1), io::Failure);
  EXPECT_THROW(ColorScale("viridis", 1, 0), io::Failure);
  EXPECT_THROW(ColorScale("viridis", 0, std::nan("")), io::Failure);
  EXPECT_THROW(ColorScale("viridis", 0, std::numeric_limits<double>::infinity()), io::Failure);
}

}  // namespace
}  // namespace pupflow::view
