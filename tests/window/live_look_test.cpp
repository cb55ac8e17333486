// The strip of colors with a real mouse: what is chosen there is on the picture that is saved.
#include <gmock/gmock.h>

#include "app/io/png.h"
#include "app/io/text.h"
#include "tests/window/live_fixture.h"

namespace pupflow::testing {
namespace {

using ::testing::HasSubstr;

class LiveLook : public Live {
 protected:
  /// What a picture saved now says of itself.
  std::map<std::string, std::string> picture() {
    screen_.press("s");
    std::map<std::string, std::string> entries;
    for (const auto& [key, value] : io::read_png_text(scratch_.path(await("screenshot ")))) {
      entries[key] = value;
    }
    return entries;
  }

  /// Opens the window and waits until everything stands where it stays.
  void open_and_settle(const std::vector<std::string>& options) {
    open(options);
    settle();
  }

  /// A list takes two frames to find its place, and a press while it is open only closes it.
  void choose(const std::string& list, const std::string& entry) {
    click(list);
    settle();
    click(entry);
    settle();
  }

  void type_into(const std::string& name, const std::string& text) {
    click(name);
    await("text on");
    type(text);
  }
};

TEST_F(LiveLook, OverlaysAndCaptionAreChosenInTheStrip) {
  open_and_settle({"--paused", "--out", "shot-%d.png"});
  for (const char* name : {"overlay-ids", "overlay-trails", "caption"}) click(name);
  widget("trail");
  auto saved = picture();
  EXPECT_EQ(saved["overlay"], "trails,ids");
  EXPECT_EQ(saved["caption"], "true");
  type_into("trail", "2,5");
  EXPECT_EQ(picture()["trail"], "2.5");
}

TEST_F(LiveLook, DrawAndQualityAreListsAndTheSamplesAreThoseOfTheQuality) {
  open_and_settle({"--paused", "--supersample", "2", "--out", "shot-%d.png"});
  choose("draw", "draw-points");
  choose("quality", "quality-fast");
  auto saved = picture();
  EXPECT_EQ(saved["draw"], "points");
  EXPECT_EQ(saved["quality"], "fast");
  EXPECT_EQ(saved["supersample"], "1");
}

TEST_F(LiveLook, TheEndsAreTypedAndWhatCannotBeIsRefusedWithItsReason) {
  open_and_settle({"--paused", "--scale", "0,1", "--out", "shot-%d.png"});
  type_into("scale_high", "0,75");
  EXPECT_EQ(picture()["scale"], "0,0.75");
  type_into("scale_low", "0.8");
  EXPECT_THAT(await("problem scale_low "), HasSubstr("below 0.75"));
  type_into("scale_low", "abc");
  EXPECT_THAT(await("problem scale_low "), HasSubstr("abc"));
  EXPECT_EQ(picture()["scale"], "0,0.75");
  type_into("scale_low", "0.25");
  EXPECT_EQ(picture()["scale"], "0.25,0.75");
}

TEST_F(LiveLook, AnEndIsDraggedAndTheListGivesTheDataItsSayAgain) {
  open_and_settle({"--paused", "--scale", "0,1", "--out", "shot-%d.png"});
  const Box grip = widget("scale_high_grip");
  screen_.press_and_move(grip.middle_x(), grip.middle_y(), grip.middle_x(), grip.middle_y() + 40);
  screen_.release();
  const std::string scale = picture()["scale"];
  const double high = io::read_number<double>(scale.substr(2)).value_or(-1);
  EXPECT_EQ(scale.substr(0, 2), "0,");
  EXPECT_LT(high, 0.95);
  EXPECT_GT(high, 0.5);
  choose("ends", "ends-around-tp");
  auto saved = picture();
  EXPECT_EQ(saved["colormap"], "bluered");
  EXPECT_NE(saved["scale"], scale);
}

TEST_F(LiveLook, CategoriesHaveNeitherEndsNorMap) {
  open_and_settle({"--paused", "--color-by", "group"});
  EXPECT_EQ(widgets().count("scale_high"), 0u);
  EXPECT_EQ(widgets().count("colormap"), 0u);
  choose("color_by", "color_by-tb");
  widget("scale_high");
  widget("colormap");
}

TEST_F(LiveLook, ALowStripHasAButtonForTheOverlays) {
  open_and_settle({"--paused", "--size", "1400x520", "--out", "shot-%d.png"});
  click("overlays");
  settle();
  click("overlay-headings");
  screen_.press("Escape");
  EXPECT_EQ(picture()["overlay"], "headings");
}

}  // namespace
}  // namespace pupflow::testing
