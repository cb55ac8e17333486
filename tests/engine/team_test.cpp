#include "engine/team.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <stdexcept>
#include <vector>

#include "pupflow/simulation.h"

namespace pupflow {
namespace {

TEST(Team, EveryWorkerDoesTheJobOnce) {
  for (int size : {1, 2, 5}) {
    Team team(size);
    ASSERT_EQ(team.size(), size);
    for (int round = 0; round < 300; ++round) {
      std::vector<std::atomic<int>> done(size);
      team.run(size, [&](int worker) { ++done[worker]; });
      for (int worker = 0; worker < size; ++worker) ASSERT_EQ(done[worker], 1);
    }
  }
}

TEST(Team, FewerWorkersThanMembers) {
  Team team(4);
  std::atomic<int> done{0};
  for (int round = 0; round < 100; ++round) {
    team.run(2, [&](int worker) { done += worker < 2 ? 1 : 1000; });
  }
  EXPECT_EQ(done, 200);
}

TEST(Team, WhatAWorkerThrowsComesOutWhenAllAreDone) {
  Team team(3);
  for (int thrower = 0; thrower < 3; ++thrower) {
    std::atomic<int> done{0};
    const auto job = [&](int worker) {
      ++done;
      if (worker == thrower) throw std::runtime_error("no");
    };
    EXPECT_THROW(team.run(3, job), std::runtime_error);
    EXPECT_EQ(done, 3);
    team.run(3, [&](int) { ++done; });  // goes on
    EXPECT_EQ(done, 6);
  }
}

TEST(Team, ACopyWorksOnItsOwn) {
  Team team(2);
  team.run(2, [](int) {});
  Team copy(team);
  std::atomic<int> done{0};
  copy.run(2, [&](int) { team.run(1, [&](int) { ++done; }); });
  EXPECT_EQ(done, 2);
  EXPECT_EQ(copy.size(), 2);
}

TEST(Team, SharesCoverAllPupsInOrder) {
  for (int pups : {0, 1, 7, 1000}) {
    for (int workers : {1, 2, 3, 8}) {
      int next = 0;
      for (int worker = 0; worker < workers; ++worker) {
        const Share share = share_of(pups, worker, workers);
        EXPECT_EQ(share.begin, next);
        EXPECT_LE(share.end - share.begin, pups / workers + 1);
        next = share.end;
      }
      EXPECT_EQ(next, pups);
    }
  }
}

TEST(Team, SmallLittersKeepToOneThread) {
  const Team team(8);
  EXPECT_EQ(useful_workers(team, 0), 1);
  EXPECT_EQ(useful_workers(team, 12), 1);
  EXPECT_EQ(useful_workers(team, 100000), 8);
  EXPECT_GT(useful_workers(team, 200), 1);
}

Params crowd(Precision precision) {
  Params p;
  p.pups = 200;
  p.face_points = 4;
  p.arena_radius = 4;  // they lie in two layers and touch
  p.start = Start::carpet;
  p.ambient_temperature = 0.2;
  p.precision = precision;
  return p;
}

class Threads : public ::testing::TestWithParam<Precision> {};

TEST_P(Threads, OneHashForOneToEightThreads) {
  const Params p = crowd(GetParam());
  Simulation alone(p);
  ASSERT_TRUE(alone.run(150).ok());
  ASSERT_GT(alone.view().touching.size(), 100u);
  for (int threads = 2; threads <= 8; ++threads) {
    Simulation shared(p);
    shared.set_threads(threads);
    ASSERT_TRUE(shared.run(150).ok());
    EXPECT_EQ(shared.hash(), alone.hash()) << threads;
    EXPECT_TRUE(std::ranges::equal(shared.view().touching, alone.view().touching)) << threads;
    EXPECT_TRUE(std::ranges::equal(shared.view().touched, alone.view().touched)) << threads;
    EXPECT_TRUE(std::ranges::equal(shared.view().exposed, alone.view().exposed)) << threads;
    EXPECT_EQ(shared.rotation_fallbacks(), alone.rotation_fallbacks()) << threads;
  }
}

TEST_P(Threads, TheSameBadStatusForAnyNumber) {
  const Params p = crowd(GetParam());
  Simulation start(p);
  ASSERT_TRUE(start.run(20).ok());
  start.set_body_temperature(190, std::numeric_limits<double>::quiet_NaN());
  start.set_body_temperature(150, std::numeric_limits<double>::quiet_NaN());
  Simulation alone = start;
  const Status status = alone.run(5);
  ASSERT_FALSE(status.ok());
  ASSERT_LE(status.pup, 150);  // itself, or a neighbour of lower number that feels it
  for (int threads : {2, 4}) {
    Simulation shared = start;
    shared.set_threads(threads);
    EXPECT_EQ(shared.run(5).message(), status.message());
    EXPECT_EQ(shared.hash(), alone.hash());
    EXPECT_EQ(shared.steps_done(), 20);
  }
}

INSTANTIATE_TEST_SUITE_P(Team, Threads, ::testing::Values(Precision::float_, Precision::double_));

TEST(Team, NoThreadsIsAnError) {
  Simulation simulation{Params{}};
  EXPECT_THROW(simulation.set_threads(0), std::invalid_argument);
}

}  // namespace
}  // namespace pupflow
