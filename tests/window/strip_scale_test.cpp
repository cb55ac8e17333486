#include "app/window/panels/strip_scale.h"

#include <gtest/gtest.h>

namespace pupflow::window {
namespace {

Timeline run_of(std::int64_t last) {
  Timeline run;
  run.last = last;
  return run;
}

TEST(StripScale, EveryStepIsFoundAgainWhereItIsDrawn) {
  const StripScale scale = strip_scale(run_of(500), 37, 640);
  for (std::int64_t step = 0; step <= scale.end; ++step) {
    EXPECT_EQ(scale.step(scale.x(static_cast<double>(step))), step);
  }
  EXPECT_FLOAT_EQ(scale.x(0), 37);
  EXPECT_FLOAT_EQ(scale.x(500), 677);
}

TEST(StripScale, BeyondTheStripIsItsEnd) {
  const StripScale scale = strip_scale(run_of(180), 10, 100);
  EXPECT_EQ(scale.step(-1000), 0);
  EXPECT_EQ(scale.step(1e6), 200);
}

TEST(StripScale, StandsStillWhileTheRunGrows) {
  EXPECT_EQ(strip_scale(run_of(0), 0, 100).end, 100);
  EXPECT_EQ(strip_scale(run_of(100), 0, 100).end, 100);
  EXPECT_EQ(strip_scale(run_of(101), 0, 100).end, 200);
  EXPECT_EQ(strip_scale(run_of(201), 0, 100).end, 500);
  EXPECT_EQ(strip_scale(run_of(501), 0, 100).end, 1000);
  EXPECT_EQ(strip_scale(run_of(1001), 0, 100).end, 2000);
}

TEST(StripScale, HasRoomForTheOtherFuture) {
  Timeline run = run_of(120);
  run.parted_at = 80;
  run.other_last = 900;
  EXPECT_EQ(strip_scale(run, 0, 100).end, 1000);
}

TEST(StripScale, ARunFromACheckpointBeginsThere) {
  Timeline run;
  run.first = 3000;
  run.last = 3150;
  const StripScale scale = strip_scale(run, 0, 200);
  EXPECT_EQ(scale.step(0), 3000);
  EXPECT_EQ(scale.end, 3200);
}

}  // namespace
}  // namespace pupflow::window
