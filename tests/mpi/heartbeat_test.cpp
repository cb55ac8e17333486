#include "app/mpi/heartbeat.h"

#include <gtest/gtest.h>

namespace pupflow::mpi {
namespace {

using std::chrono::milliseconds;

constexpr Clock::time_point kStart{};

TEST(HeartbeatTimer, AHeartbeatIsDueAfterEveryEighthOfTheTime) {
  HeartbeatTimer timer(milliseconds(8000), kStart);
  for (int ms = 1; ms <= 3000; ++ms) {
    EXPECT_EQ(timer.check(kStart + milliseconds(ms)).send, ms % 1000 == 0) << ms;
  }
}

TEST(HeartbeatTimer, ARankIsLostOnlyAfterTheWholeTime) {
  const HeartbeatTimer timer(milliseconds(8000), kStart);
  EXPECT_FALSE(timer.is_lost(kStart, kStart + milliseconds(8000)));
  EXPECT_TRUE(timer.is_lost(kStart, kStart + milliseconds(8001)));
}

TEST(HeartbeatTimer, APauseOfThisRankIsSeenOnce) {
  HeartbeatTimer timer(milliseconds(8000), kStart);
  EXPECT_FALSE(timer.check(kStart + milliseconds(2000)).paused);
  EXPECT_TRUE(timer.check(kStart + milliseconds(4001)).paused);
  EXPECT_FALSE(timer.check(kStart + milliseconds(4002)).paused);
}

}  // namespace
}  // namespace pupflow::mpi
