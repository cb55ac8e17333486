// Pictures that the window saves.
#include <gmock/gmock.h>

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

}  // namespace
}  // namespace pupflow::testing
