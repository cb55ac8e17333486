// The color maps before eyes that lack a kind of cone.
#include "tests/pictures/color_vision.h"

#include <gtest/gtest.h>

#include "app/gl/renderer.h"
#include "app/view/color_scale.h"
#include "app/view/colormap.h"

namespace pupflow::view {
namespace {

using test::difference;
using test::kVisions;
using test::lab;
using test::Vision;

TEST(ColorVision, ThoseWhoLackAConeConfuseWhatTheyAreKnownTo) {
  const Rgb red{200, 60, 40}, green{110, 110, 30};  // nearly one to deuteranopes
  EXPECT_GT(difference(red, green), 60);
  EXPECT_LT(difference(red, green, Vision::deuteranopia), 30);
  EXPECT_NEAR(lab({255, 255, 255}, Vision::protanopia).x(), 100, 1);
}

TEST(ColorVision, SequentialMapsKeepTheirOrder) {
  for (const char* name : {"viridis", "inferno", "cividis"}) {
    const Colormap map = find_colormap(name);
    for (const Vision vision : kVisions) {
      for (std::size_t i = 32; i < map.size(); i += 32) {
        EXPECT_GT(lab(map[i], vision).x(), lab(map[i - 32], vision).x() + 4) << name << " " << i;
      }
      EXPECT_GT(difference(map.front(), map.back(), vision), 70) << name;
    }
  }
}

TEST(ColorVision, TheDivergingMapDarkensToTwoEndsThatDiffer) {
  const Colormap map = find_colormap("bluered");
  for (const Vision vision : kVisions) {
    for (std::size_t i = 16; i < 128; i += 16) {
      EXPECT_GT(lab(map[i], vision).x(), lab(map[i - 16], vision).x() + 2) << i;
      EXPECT_GT(lab(map[255 - i], vision).x(), lab(map[271 - i], vision).x() + 2) << i;
    }
    for (std::size_t i = 0; i < 96; i += 8) {
      EXPECT_GT(difference(map[i], map[255 - i], vision), 20) << i;
    }
  }
}

TEST(ColorVision, AnglesAnEighthOfATurnApartCanBeTold) {
  const Colormap map = find_colormap("phase");
  for (const Vision vision : kVisions) {
    for (std::size_t i = 0; i < 256; i += 4) {
      for (std::size_t away = 32; away <= 128; away += 4) {
        EXPECT_GT(difference(map[i], map[(i + away) % 256], vision), away < 64 ? 10 : 20)
            << i << " " << away;
      }
    }
  }
}

TEST(ColorVision, CategoriesCanBeToldFromEachOtherAndFromGreys) {
  const Colormap colors = category_colors();
  for (const Vision vision : kVisions) {
    for (std::size_t i = 0; i < kCategoryColors; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GT(difference(colors[i], colors[j], vision), 22) << i << " " << j;
      }
      for (const Rgb grey : {kUnknownColor, kNobodyColor, gl::Palette{}.floor}) {
        EXPECT_GT(difference(colors[i], grey, vision), 15) << i;
      }
    }
  }
}

}  // namespace
}  // namespace pupflow::view
