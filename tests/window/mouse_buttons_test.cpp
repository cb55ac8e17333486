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

/// A press on one place, and the mouse is at another one before the next frame.
TEST(MouseButtons, AChangeIsWhereTheMouseWasThen) {
  MouseButtons buttons;
  ImGuiIO io;
  const auto click = [&](float x, float y, double time) {
    buttons.moved({x, y});
    buttons.changed(0, true, time);
    buttons.changed(0, false, time + 0.01);
  };
  click(10, 20, 1);
  click(300, 40, 2);
  buttons.moved({500, 60});
  std::vector<float> places;
  for (int frame = 0; frame < 5; ++frame) {
    io.MousePos = {500, 60};  // as the backend has it
    buttons.apply(io);
    places.push_back(io.MousePos.x);
  }
  EXPECT_EQ(places, (std::vector<float>{10, 10, 300, 300, 500}));
}

TEST(MouseButtons, ButtonsAtTwoPlacesTakeTwoFrames) {
  MouseButtons buttons;
  ImGuiIO io;
  buttons.moved({10, 20});
  buttons.changed(0, true, 1);
  buttons.moved({10, 90});
  buttons.changed(1, true, 1);
  buttons.apply(io);
  EXPECT_TRUE(io.MouseDown[0]);
  EXPECT_FALSE(io.MouseDown[1]);
  EXPECT_EQ(io.MousePos.y, 20);
  buttons.apply(io);
  EXPECT_TRUE(io.MouseDown[1]);
  EXPECT_EQ(io.MousePos.y, 90);
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
