// One seed, one hash: for every compiler, build type and instruction set. A change of the
// arithmetic changes these numbers; it must be meant, and the changelog must say so.
#include <gtest/gtest.h>

#include "engine/simulation.h"

namespace pupflow {
namespace {

std::uint64_t hash_after(void (*edit)(Params&)) {
  Params p;
  p.ta = 0.2;
  edit(p);
  Simulation s(p);
  EXPECT_TRUE(s.run(800).ok());
  return s.hash();
}

TEST(Golden, ThePapersLitter) {
  EXPECT_EQ(hash_after([](Params&) {}), 0x03dba221ac572016u);
  EXPECT_EQ(hash_after([](Params& p) { p.precision = Precision::float_; }), 0xeef8a29229d365a9u);
}

TEST(Golden, BodyHeadingAndEulerHeat) {
  EXPECT_EQ(hash_after([](Params& p) {
              p.heading = Heading::body;
              p.heat = HeatRule::euler;
            }),
            0x2944363fa7686e38u);
}

TEST(Golden, RigidPupsOnACarpet) {
  EXPECT_EQ(hash_after([](Params& p) {
              p.alpha = 1;
              p.beta = 0;
              p.pups = 40;
              p.start = Start::carpet;
              p.precision = Precision::float_;
            }),
            0xe7cd989af6075a2fu);
}

}  // namespace
}  // namespace pupflow
