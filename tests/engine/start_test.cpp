
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "pupflow/geometry.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

TEST(Start, ColumnIsThePapers) {
  Params p;
  const auto centres = start_centres(p);
  ASSERT_EQ(centres.size(), 12u);
  for (int j = 0; j < 12; ++j) {
    EXPECT_DOUBLE_EQ(centres[j].z(), j + 0.3);
    EXPECT_LE(std::abs(centres[j].x()), 0.25);
    EXPECT_LE(std::abs(centres[j].y()), 0.25);
  }
  EXPECT_NE(centres[0].x(), centres[1].x());
}

TEST(Start, LargePupsHangFurtherApart) {
  Params p;
  p.pup_radius = 2.5;
  p.point_radius = 0.5;
  p.arena_radius = 20;
  const auto centres = start_centres(p);
  for (int j = 0; j < 12; ++j) EXPECT_DOUBLE_EQ(centres[j].z(), 6 * j + 3);
}

TEST(Start, SeedFixesItAndPupsDrawApart) {
  Params a, b;
  b.seed = 2;
  EXPECT_NE(start_centres(a)[0], start_centres(b)[0]);
  b = a;
  b.pups = 20;  // more pups change nothing for the others
  for (int j = 0; j < 12; ++j) EXPECT_EQ(start_centres(a)[j], start_centres(b)[j]);
}

TEST(Start, PupsBeginAtRestWholeAndWarm) {
  const Simulation s{Params{}};
  for (int pup = 0; pup < s.pups(); ++pup) {
    for (const auto& p : testing::of_pup(s, pup, testing::all_positions(s))) {
      ASSERT_NEAR((p - s.view().positions.mean(pup)).norm(), 0.25, 1e-12);
    }
    EXPECT_EQ(s.view().tb[pup], 0.6);
    EXPECT_EQ(s.view().exposed[pup], 1);
  }
  for (const auto& v : testing::all_velocities(s)) ASSERT_EQ(v.norm(), 0);
  const auto heading = s.view().heading;
  EXPECT_GT(std::set<double>(heading.begin(), heading.end()).size(), 11u);
}

TEST(Start, CarpetKeepsPupsApartInsideTheArena) {
  for (const int pups : {1, 2, 12, 100, 1000}) {
    Params p;
    p.start = Start::carpet;
    p.pups = pups;
    p.arena_radius = 2 * std::sqrt(std::max(pups, 12) / 12.0);
    const auto centres = start_centres(p);
    ASSERT_EQ(centres.size(), static_cast<std::size_t>(pups));
    for (std::size_t a = 0; a < centres.size(); ++a) {
      EXPECT_LE(std::hypot(centres[a].x(), centres[a].y()), p.arena_radius - 0.3 + 1e-9);
      EXPECT_GE(centres[a].z(), 0.3);
      for (std::size_t b = 0; b < a; ++b) ASSERT_GE((centres[a] - centres[b]).norm(), 0.6) << pups;
    }
    EXPECT_LT(centres.back().z(), 0.4);  // at the paper's density one layer is enough
  }
}

TEST(Start, CarpetStacksLayersWhenTheFloorIsFull) {
  Params p;
  p.start = Start::carpet;
  p.pups = 200;
  const auto centres = start_centres(p);
  std::set<long> heights;
  for (const auto& c : centres) heights.insert(std::lround(c.z() * 1e6));
  EXPECT_GT(heights.size(), 2u);
  EXPECT_LT(heights.size(), 12u);
}

TEST(Start, ATinyArenaStillTakesACarpet) {
  Params p;
  p.start = Start::carpet;
  p.arena_radius = 0.3001;
  p.pups = 5;
  for (const auto& c : start_centres(p)) EXPECT_LE(std::hypot(c.x(), c.y()), 0.0001 + 1e-12);
}

}  // namespace
}  // namespace pupflow
