#include "app/window/mouse_buttons.h"

#include <gtest/gtest.h>

#include <vector>

namespace pupflow::window {
namespace {

/// The left button in each of so many frames.
std::vector<bool> frames(MouseButtons& buttons, ImGuiIO& io, int count) {
  std::vector<bool> down;
  for (int i = 0; i < count; ++i) {
    buttons.apply(io);
    down.push_back(io.MouseDown[0]);
  }
  return down;
}

TEST(MouseButtons, TwoClicksBetweenTwoFramesAreTwo) {
  MouseButtons buttons;
  ImGuiIO io;
  for (const double time : {1.0, 1.1}) {
    buttons.changed(0, true, time);
    buttons.changed(0, false, time);
  }
  EXPECT_TRUE(buttons.waiting());
  EXPECT_EQ(frames(buttons, io, 5), (std::vector<bool>{true, false, true, false, false}));
  EXPECT_FALSE(buttons.waiting());
}

TEST(MouseButtons, ADoubleClickIsOneHoweverLongItsFramesTake) {
  MouseButtons buttons;
  ImGuiIO io;
  buttons.changed(0, true, 1);
  buttons.apply(io);
  EXPECT_LT(io.MouseDoubleClickTime, 1);
  buttons.changed(0, false, 1.1);
  buttons.changed(0, true, 1.2);
  frames(buttons, io, 2);
  EXPECT_GT(io.MouseDoubleClickTime, 10);
  buttons.changed(0, false, 1.3);
  buttons.changed(0, true, 3);
  frames(buttons, io, 2);
  EXPECT_LT(io.MouseDoubleClickTime, 1) << "two clicks";
}

TEST(MouseButtons, ButtonsDoNotWaitForEachOther) {
  MouseButtons buttons;
  ImGuiIO io;
  buttons.changed(0, true, 1);
  buttons.changed(1, true, 1);
  buttons.changed(17, true, 1);
  buttons.apply(io);
  EXPECT_TRUE(io.MouseDown[0]);
  EXPECT_TRUE(io.MouseDown[1]);
  EXPECT_FALSE(buttons.waiting());
}

}  // namespace
}  // namespace pupflow::window
