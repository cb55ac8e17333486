#include "app/mpi/run_queue.h"

#include <gtest/gtest.h>

namespace pupflow::mpi {
namespace {

TEST(RunQueue, AssignsEveryRunOnceTheLowestFirst) {
  RunQueue queue(3);
  EXPECT_EQ(queue.assign(1), 0);
  EXPECT_EQ(queue.assign(2), 1);
  EXPECT_EQ(queue.assign(1), 2);
  EXPECT_EQ(queue.assign(2), std::nullopt);
  EXPECT_EQ(queue.assigned_to(1), 2u);
  EXPECT_TRUE(queue.finish(1, 2));
  EXPECT_TRUE(queue.finish(1, 0));
  EXPECT_FALSE(queue.all_finished());
  EXPECT_TRUE(queue.finish(2, 1));
  EXPECT_TRUE(queue.all_finished());
}

TEST(RunQueue, WithoutRunsIsFinished) {
  RunQueue queue(0);
  EXPECT_TRUE(queue.all_finished());
  EXPECT_EQ(queue.assign(0), std::nullopt);
}

TEST(RunQueue, RequeuedRunsAreAssignedFirst) {
  RunQueue queue(5);
  for (int i = 0; i < 3; ++i) queue.assign(1);
  EXPECT_TRUE(queue.finish(1, 1));
  queue.requeue(1);
  EXPECT_EQ(queue.assigned_to(1), 0u);
  EXPECT_EQ(queue.assign(2), 0);
  EXPECT_EQ(queue.assign(2), 2);
  EXPECT_EQ(queue.assign(2), 3);
}

TEST(RunQueue, OnlyTheFirstOfTwoRanksThatFinishARunCounts) {
  RunQueue queue(2);
  queue.assign(1);
  queue.requeue(1);
  EXPECT_EQ(queue.assign(2), 0);
  EXPECT_TRUE(queue.finish(1, 0));  // the lost rank was only slow
  EXPECT_FALSE(queue.finish(2, 0));
  EXPECT_EQ(queue.assigned_to(2), 0u);
  EXPECT_FALSE(queue.all_finished());
  EXPECT_EQ(queue.assign(2), 1);
}

TEST(RunQueue, ARunFinishedAfterItWasRequeuedIsNotAssignedAgain) {
  RunQueue queue(1);
  queue.assign(1);
  queue.requeue(1);
  EXPECT_TRUE(queue.finish(1, 0));
  EXPECT_EQ(queue.assign(2), std::nullopt);
}

}  // namespace
}  // namespace pupflow::mpi
