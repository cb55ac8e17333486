#include "app/window/session/pacer.h"

#include <gmock/gmock.h>

#include <limits>

namespace pupflow::window {
namespace {

constexpr double kDt = 0.01;

/// Steps that are due while the clock goes from `from` to `to` in ticks; a step takes no time.
int steps_between(Pacer& pacer, double from, double to, double tick, double interval) {
  int steps = 0;
  for (int i = 0; from + i * tick < to; ++i) {
    const double now = from + i * tick;
    while (pacer.due(now)) {
      pacer.stepped(now, interval);
      ++steps;
    }
  }
  return steps;
}

TEST(Pacer, RealTimeIsOneSecondOfStepsInASecond) {
  Pacer pacer;
  pacer.reschedule(0, kDt);
  EXPECT_NEAR(steps_between(pacer, 0, 10, 0.0007, step_interval(kDt, 1)), 1000, 1);
}

TEST(Pacer, KeepsToOtherSpeeds) {
  for (const double speed : {0.1, 2.0, 20.0}) {
    Pacer pacer;
    pacer.reschedule(5, kDt);
    EXPECT_NEAR(steps_between(pacer, 5, 15, 0.0007, step_interval(kDt, speed)), 1000 * speed, 2)
        << speed;
  }
}

TEST(Pacer, TicksCoarserThanStepsLoseNone) {
  Pacer pacer;
  pacer.reschedule(0, kDt);
  EXPECT_NEAR(steps_between(pacer, 0, 10, 0.03, step_interval(kDt, 1)), 1000, 3);
}

TEST(Pacer, AsFastAsPossibleIsAlwaysDue) {
  Pacer pacer;
  const double interval = step_interval(kDt, std::numeric_limits<double>::infinity());
  EXPECT_EQ(interval, 0);
  pacer.reschedule(3, interval);
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(pacer.due(3));
    pacer.stepped(3, interval);
  }
}

TEST(Pacer, ASlowMachineGathersNoBacklog) {
  Pacer pacer;
  double now = 0;
  pacer.reschedule(now, kDt);
  for (int i = 0; i < 100; ++i) {  // each step takes five intervals
    ASSERT_TRUE(pacer.due(now));
    pacer.stepped(now, kDt);
    now += 5 * kDt;
  }
  int burst = 0;
  while (pacer.due(now)) {
    pacer.stepped(now, kDt);
    ++burst;
  }
  EXPECT_LE(burst, Pacer::kLongestDelay / kDt + 2);
}

TEST(Pacer, CatchesUpAfterAShortDelay) {
  Pacer pacer;
  pacer.reschedule(0, kDt);
  const int before = steps_between(pacer, 0, 1, 0.001, kDt);
  const int after = steps_between(pacer, 1.05, 2, 0.001, kDt);
  EXPECT_NEAR(before + after, 200, 1);
}

TEST(Pacer, ANewSpeedAppliesAtOnce) {
  Pacer pacer;
  pacer.reschedule(0, 1000);
  pacer.stepped(0, 1000);
  EXPECT_FALSE(pacer.due(1));
  pacer.reschedule(1, kDt);
  EXPECT_TRUE(pacer.due(1 + 1.01 * kDt));
}

TEST(Pacer, ALongRestLeavesNoBacklog) {
  Pacer pacer;
  pacer.reschedule(0, kDt);
  pacer.stepped(0, kDt);
  pacer.reschedule(100, kDt);
  EXPECT_LE(steps_between(pacer, 100, 100.0005, 0.001, kDt), 1);
}

}  // namespace
}  // namespace pupflow::window
