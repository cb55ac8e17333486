#include "app/mpi/agenda.h"

#include <gtest/gtest.h>

namespace pupflow::mpi {
namespace {

TEST(Agenda, HandsOutEveryRunOnceTheLowestFirst) {
  Agenda agenda(3);
  EXPECT_EQ(agenda.take(1), 0);
  EXPECT_EQ(agenda.take(2), 1);
  EXPECT_EQ(agenda.take(1), 2);
  EXPECT_EQ(agenda.take(2), std::nullopt);
  EXPECT_EQ(agenda.held_by(1), 2u);
  EXPECT_TRUE(agenda.finish(1, 2));
  EXPECT_TRUE(agenda.finish(1, 0));
  EXPECT_FALSE(agenda.finished());
  EXPECT_TRUE(agenda.finish(2, 1));
  EXPECT_TRUE(agenda.finished());
}

TEST(Agenda, WithoutRunsIsFinished) {
  Agenda agenda(0);
  EXPECT_TRUE(agenda.finished());
  EXPECT_EQ(agenda.take(0), std::nullopt);
}

TEST(Agenda, WhatARankLeavesUndoneGoesToOthersFirst) {
  Agenda agenda(5);
  for (int i = 0; i < 3; ++i) agenda.take(1);
  EXPECT_TRUE(agenda.finish(1, 1));
  agenda.give_back(1);
  EXPECT_EQ(agenda.held_by(1), 0u);
  EXPECT_EQ(agenda.take(2), 0);
  EXPECT_EQ(agenda.take(2), 2);
  EXPECT_EQ(agenda.take(2), 3);
}

TEST(Agenda, OfTwoThatFinishOneRunOnlyTheFirstCounts) {
  Agenda agenda(2);
  agenda.take(1);
  agenda.give_back(1);
  EXPECT_EQ(agenda.take(2), 0);
  EXPECT_TRUE(agenda.finish(1, 0));  // the lost rank was only slow
  EXPECT_FALSE(agenda.finish(2, 0));
  EXPECT_EQ(agenda.held_by(2), 0u);
  EXPECT_FALSE(agenda.finished());
  EXPECT_EQ(agenda.take(2), 1);
}

TEST(Agenda, ARunFinishedAfterItWasGivenBackIsNotHandedOutAgain) {
  Agenda agenda(1);
  agenda.take(1);
  agenda.give_back(1);
  EXPECT_TRUE(agenda.finish(1, 0));
  EXPECT_EQ(agenda.take(2), std::nullopt);
}

}  // namespace
}  // namespace pupflow::mpi
