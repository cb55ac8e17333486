// What passes between the window and the display: files that are dropped, the clipboard, other windows
// that cover it, two arenas, and the order in which panels and arena change.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "tests/window/live_fixture.h"
#include "tests/window/x_client.h"

namespace pupflow::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class LiveDisplay : public Live {
 protected:
  XClient client_{screen_.display()};
};

TEST_F(LiveDisplay, ADroppedSceneIsOpened) {
  open({"--paused"});
  const std::string path = scratch_.path("dropped.toml");
  std::ofstream(path) << "ta = 0.3125\n";
  client_.drop(path);
  EXPECT_EQ(await("value ta "), "0.3125");
}

TEST_F(LiveDisplay, ADroppedFileThatIsNoneIsRefused) {
  open({"--paused"});
  client_.drop(scratch_.path("nobody.toml"));
  EXPECT_THAT(await("refused "), HasSubstr("nobody.toml"));
}

TEST_F(LiveDisplay, TheCopiedCommandIsInTheClipboard) {
  open({"cold", "--paused", "--seed", "6"});
  screen_.press("ctrl+c");
  const std::string said = await("copied ");
  EXPECT_THAT(said, StartsWith("pupflow run cold --seed 6"));
  EXPECT_EQ(client_.clipboard(), said);
}

TEST_F(LiveDisplay, ACoveredWindowDrawsNothingAndGoesOnStepping) {
  open();
  await("samples ");
  client_.cover();
  EXPECT_EQ(await("visible "), "no");
  settle();  // what was under way
  EXPECT_THAT(settle(std::chrono::milliseconds(700)), ::testing::IsEmpty());
  client_.uncover();
  EXPECT_EQ(await("visible "), "yes");
  const std::int64_t seen = std::stoll(await("step "));
  EXPECT_GT(std::stoll(await("step ")), seen);
}

TEST_F(LiveDisplay, BothArenasShowTheirLitter) {
  open({"--paused"});
  await("samples ");
  const Box arena = widget("arena");
  click("compare");
  click("compare-value");
  await("text on");
  type("0.7");
  click("compare-start");
  await("second ");
  settle();
  // Bodies are colored, dish and floor are gray.
  const auto colored = [&](int left, int top, int width, int height) {
    constexpr int kEvery = 4;
    int count = 0;
    for (int y = top; y < top + height; y += kEvery) {
      for (int x = left; x < left + width; x += kEvery) {
        const unsigned long color = client_.pixel(x, y);
        const auto [least, most] =
            std::minmax({color >> 16 & 0xff, color >> 8 & 0xff, color & 0xff});
        count += most - least > 40;
      }
    }
    return count;
  };
  // The halves are cut across the longer side.
  const bool beside = arena.width >= arena.height;
  const int width = beside ? arena.width / 2 : arena.width;
  const int height = beside ? arena.height : arena.height / 2;
  EXPECT_GT(colored(arena.x, arena.y, width, height), 20);
  EXPECT_GT(colored(arena.x + arena.width - width, arena.y + arena.height - height, width, height),
            20);
}

/// An arena that takes long to draw: what the panels show changes several times in between.
TEST_F(LiveDisplay, PanelsNeverWaitForTheArena) {
  open({"--set", "pups=3000", "--set", "start=carpet", "--set", "ta=0.1", "--quality", "normal"});
  await("arena ta ");
  const Box slider = widget("ta");
  std::vector<std::string> moves{"mousemove", std::to_string(slider.x + slider.width / 8),
                                 std::to_string(slider.middle_y()), "mousedown", "1"};
  constexpr int kMoves = 40;
  for (int i = 1; i <= kMoves; ++i) {
    const int x = slider.x + slider.width / 8 + i * slider.width / (2 * kMoves);
    moves.insert(moves.end(), {"mousemove", std::to_string(x), std::to_string(slider.middle_y()),
                               "sleep", "0.03"});
  }
  screen_.hand(moves);
  screen_.release();
  int in_a_row = 0, most = 0;
  std::string panels, arena;
  while (arena.empty() || panels.empty() || arena != panels || most < 2) {
    const std::string line = await("");
    if (line.starts_with("panels ta ")) {
      panels = line.substr(10);
      most = std::max(most, ++in_a_row);
    } else if (line.starts_with("arena ta ")) {
      arena = line.substr(9);
      in_a_row = 0;
    }
    if (most >= 2 && arena == panels) break;
  }
  EXPECT_GE(most, 2) << "values on the panels between two pictures of the arena";
  EXPECT_EQ(arena, panels) << "and the arena comes after";
}

}  // namespace
}  // namespace pupflow::testing
