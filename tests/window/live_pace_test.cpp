// Pictures that the window saves.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <utility>

#include "app/io/png.h"
#include "tests/window/live_fixture.h"

namespace pupflow::testing {
namespace {

TEST_F(Live, ThePictureIsAsLargeAsTheArenaAndRenderLikeItGivesItAgain) {
  open({"--paused", "--seed", "4", "--out", "live.png"});
  screen_.press("n");
  await("hash 1 ");
  screen_.press_and_move(700, 450, 780, 470);
  screen_.release();
  await("camera ");
  screen_.press("s");
  ASSERT_EQ(await("screenshot "), "live.png");
  ASSERT_EQ(run_command({.arguments = {PUPFLOW_PROGRAM, "render", "--like", "live.png", "--out",
                                       "render.png", "--quiet"},
                         .environment = screen_.environment(),
                         .folder = scratch_.folder().string()}),
            0);
  const io::Image live = io::read_png(scratch_.path("live.png"));
  const io::Image render = io::read_png(scratch_.path("render.png"));
  EXPECT_LT(live.width, 1400);
  EXPECT_GT(live.height, 400);
  EXPECT_EQ(live.width, render.width);
  EXPECT_EQ(live.height, render.height);
  EXPECT_TRUE(live.rgba == render.rgba);
}

TEST_F(Live, APictureHasTheSizeThatIsChosen) {
  open({"--paused", "--out", "live.png"});
  const auto size = [&] {
    screen_.press("s");
    const io::Image image = io::read_png(scratch_.path(await("screenshot ")));
    return std::pair(image.width, image.height);
  };
  const auto choose = [&](const std::string& name) {
    settle();
    click("picture-sizes");
    settle();
    click(name);
  };
  const auto [width, height] = size();
  choose("picture-twice");
  EXPECT_EQ(size(), std::pair(2 * width, 2 * height));
  choose("picture-4k");
  EXPECT_EQ(size(), std::pair(3840, 2160));
  choose("picture-pixels");
  await("text on");
  type("321x123");
  screen_.press("Escape");
  EXPECT_EQ(size(), std::pair(321, 123));
}

TEST_F(Live, APictureOfAComparisonHasBothLittersAndRenderGivesTheFirst) {
  open({"--paused", "--set", "pups=3", "--out", "live.png"});
  click("compare");
  click("compare-value");
  await("text on");
  type("0.1");
  click("compare-start");
  await("second ");
  screen_.press("shift+n");
  await("hash 100 ");
  settle();
  screen_.press("s");
  ASSERT_EQ(await("screenshot "), "live.png");
  ASSERT_EQ(run_command({.arguments = {PUPFLOW_PROGRAM, "render", "--like", "live.png", "--out",
                                       "render.png", "--quiet"},
                         .environment = screen_.environment(),
                         .folder = scratch_.folder().string()}),
            0);
  std::map<std::string, std::string> entries;
  for (const auto& [key, value] : io::read_png_text(scratch_.path("live.png"))) {
    entries[key] = value;
  }
  EXPECT_EQ(entries["second"], "ta=0.1");
  const io::Image live = io::read_png(scratch_.path("live.png"));
  const io::Image render = io::read_png(scratch_.path("render.png"));
  const bool beside = live.height == render.height;
  EXPECT_EQ(beside ? live.width > render.width : live.width == render.width, true);
  const int x = render.width / 4, y = render.height / 2;  // below the title
  EXPECT_TRUE(std::equal(live.pixel(x, y), live.pixel(x, y) + 3, render.pixel(x, y)));
}

}  // namespace
}  // namespace pupflow::testing
