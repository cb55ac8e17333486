#include "pupflow/simulation.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <stdexcept>
#include <thread>

#include "tests/support/litter.h"

namespace pupflow {
namespace {

TEST(Simulation, PupsOutOfReachAreNotSearched) {
  Params p;
  p.pups = 3;
  p.start_spread = 0;
  Simulation falling(p);  // one above the other, a diameter and more apart
  ASSERT_TRUE(falling.run(20).ok());
  EXPECT_EQ(falling.searched_pairs(), 0);
  ASSERT_TRUE(falling.run(300).ok());  // they land on each other
  EXPECT_GT(falling.searched_pairs(), 0);
  EXPECT_LE(falling.searched_pairs(), 3 * 300);
}

TEST(Simulation, SameSeedSameBits) {
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    Params p;
    p.precision = precision;
    Simulation a(p), b(p);
    a.run(300);
    b.run(300);
    EXPECT_EQ(a.hash(), b.hash());
    p.seed = 2;
    Simulation c(p);
    c.run(300);
    EXPECT_NE(a.hash(), c.hash());
  }
}

TEST(Simulation, ACopyIsASnapshotThatGoesOnAlike) {
  Params p;
  Simulation a(p);
  a.run(350);
  Simulation b = a;
  const std::uint64_t there = a.hash();
  a.run(100);
  EXPECT_EQ(b.hash(), there);
  b.run(100);
  EXPECT_EQ(a.hash(), b.hash());
  Simulation c(p);
  c = a;
  EXPECT_EQ(c.hash(), a.hash());
  const Simulation d = std::move(c);
  EXPECT_EQ(d.hash(), a.hash());
}

TEST(Simulation, CopiesShareNothing) {
  Params p;
  p.ambient_temperature = 0.2;
  auto original = std::make_unique<Simulation>(p);
  original->run(400);
  Simulation a = *original, b = *original;
  original->run(300);
  const std::uint64_t expected = original->hash();
  original.reset();
  std::jthread other([&] { a.run(300); });
  b.run(300);
  other.join();
  EXPECT_EQ(a.hash(), expected);
  EXPECT_EQ(b.hash(), expected);
}

TEST(Simulation, ASnapshotGoesOnBitForBit) {
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    Params p;
    p.precision = precision;
    p.ambient_temperature = 0.2;
    Simulation a(p);
    a.run(400);
    Simulation b(a.snapshot());
    EXPECT_EQ(b.hash(), a.hash());
    EXPECT_EQ(std::vector(b.view().touching.begin(), b.view().touching.end()),
              std::vector(a.view().touching.begin(), a.view().touching.end()));
    EXPECT_EQ(b.view().exposed[3], a.view().exposed[3]);
    a.run(300);
    b.run(300);
    EXPECT_EQ(b.hash(), a.hash());
    EXPECT_EQ(b.time(), a.time());
  }
}

TEST(Simulation, ASnapshotThatDoesNotFitIsRefused) {
  const Snapshot good = Simulation(Params{}).snapshot();
  const auto refuse = [&](void (*spoil)(Snapshot&)) {
    Snapshot bad = good;
    spoil(bad);
    EXPECT_THROW(Simulation{bad}, std::invalid_argument);
  };
  refuse([](Snapshot& s) { s.positions.pop_back(); });
  refuse([](Snapshot& s) { s.heading.push_back(0); });
  refuse([](Snapshot& s) { s.touched[5] = 12; });
  refuse([](Snapshot& s) { s.touching.push_back({3, 2}); });
  refuse([](Snapshot& s) { s.params.pups = 11; });
  refuse([](Snapshot& s) { s.exposed[0] = NAN; });
  refuse([](Snapshot& s) { s.actions.resize(12), s.actions[3].turn = NAN; });
  refuse([](Snapshot& s) { s.step = INT64_MAX; });
  refuse([](Snapshot& s) { s.clock.step = 1; });
  refuse([](Snapshot& s) { s.clock.time = NAN; });
  refuse([](Snapshot& s) { s.params.rigidity = 2; });
}

TEST(Simulation, UnsoundParametersAreRefusedWhole) {
  Params p;
  p.rigidity = 3;
  p.pups = -1;
  try {
    const Simulation s(p);
    FAIL() << "no exception";
  } catch (const InvalidParams& error) {
    EXPECT_EQ(error.problems().size(), 2u);
  }
}

TEST(Simulation, ParametersActOnTheNextStep) {
  Params p = testing::weightless();
  Simulation s(p);
  s.run(10);
  const double before = s.view().positions.mean(0).z();
  p.gravity = 10;
  s.set_params(p);
  s.step();
  EXPECT_NEAR(s.view().positions.mean(0).z(), before - 10 * 0.01 * 0.01, 1e-12);
}

TEST(Simulation, LitterParametersCannotChangeInFlight) {
  Params p;
  Simulation s(p);
  p.pups = 5;
  EXPECT_THROW(s.set_params(p), std::logic_error);
  p = Params{};
  p.rigidity = 7;
  EXPECT_THROW(s.set_params(p), InvalidParams);
  EXPECT_EQ(s.params(), Params{});
}

TEST(Simulation, TimeGathersNoRounding) {
  Params p = testing::weightless();
  p.rigidity = 0;
  Simulation s(p);
  s.run(501);
  EXPECT_EQ(s.time(), 5.01);
}

TEST(Simulation, TimeIsTheSumOfTheSteps) {
  Params p = testing::weightless();
  Simulation s(p);
  s.run(10);
  p.dt = 0.02;
  s.set_params(p);
  s.run(10);
  EXPECT_EQ(s.steps_done(), 20);
  EXPECT_NEAR(s.time(), 0.3, 1e-15);
}

TEST(Simulation, WrongSizesAndPupsAreRefused) {
  Simulation s{Params{}};
  std::vector<double> few(3);
  EXPECT_THROW(s.view().positions.copy_to(few), std::invalid_argument);
  EXPECT_THROW(s.set_cloud(0, few, few), std::invalid_argument);
  EXPECT_THROW(s.set_cloud(12, few, few), std::out_of_range);
  EXPECT_THROW(s.view().positions.mean(-1), std::out_of_range);
  EXPECT_THROW(s.set_heading(99, 0), std::out_of_range);
}

TEST(Simulation, FloatStaysCloseToDoubleBeforeChaosSetsIn) {
  Params p;
  Simulation fine(p);
  p.precision = Precision::float_;
  Simulation coarse(p);
  fine.run(20);
  coarse.run(20);
  for (int pup = 0; pup < p.pups; ++pup) {
    EXPECT_LT((fine.view().positions.mean(pup) - coarse.view().positions.mean(pup)).norm(), 5e-5);
  }
}

TEST(Simulation, PointsTouchWhomThePairsSay) {
  Simulation s{Params{}};
  s.run(400);
  const auto touched = s.view().touched;
  std::set<std::pair<int, int>> pairs;
  for (int pup = 0; pup < s.pups(); ++pup) {
    int contacts = 0;
    for (int i = 0; i < s.points(); ++i) {
      const int other = touched[static_cast<std::size_t>(pup) * s.points() + i];
      if (other < 0) continue;
      ++contacts;
      ASSERT_NE(other, pup);
      pairs.insert({std::min(pup, other), std::max(pup, other)});
    }
    EXPECT_NEAR(s.view().exposed[pup], 1 - static_cast<double>(contacts) / s.points(), 1e-12);
  }
  std::set<std::pair<int, int>> listed;
  for (const TouchingPair& pair : s.view().touching) listed.insert({pair.first, pair.second});
  for (const auto& pair : pairs) EXPECT_TRUE(listed.contains(pair));
}

}  // namespace
}  // namespace pupflow
