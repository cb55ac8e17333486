// One seed, one hash: for every compiler, build type and instruction set. A change of the
// arithmetic changes these numbers; it must be meant, and the changelog must say so.
#include <gtest/gtest.h>

#include "pupflow/simulation.h"

namespace pupflow {
namespace {

std::uint64_t hash_after(void (*edit)(Params&)) {
  Params p;
  p.ambient_temperature = 0.2;
  edit(p);
  const auto sets = supported_instruction_sets();
  std::uint64_t hash = 0;
  for (const InstructionSet set : sets) {
    Simulation s(p, set);
    EXPECT_TRUE(s.run(800).ok());
    if (set == sets.front()) hash = s.hash();
    EXPECT_EQ(s.hash(), hash) << instruction_set_name(set);
  }
  return hash;
}

TEST(Golden, ThePapersLitter) {
  EXPECT_EQ(hash_after([](Params&) {}), 0xc696efdc14174a71u);
  EXPECT_EQ(hash_after([](Params& p) { p.precision = Precision::float_; }), 0x9040f420f93e22e4u);
}

/// The hashes of version 0.1.0, whose only rule this was.
TEST(Golden, SummedContacts) {
  EXPECT_EQ(hash_after([](Params& p) { p.contact = ContactRule::sum; }), 0x6b6d41fe3fe481dfu);
  EXPECT_EQ(hash_after([](Params& p) {
              p.contact = ContactRule::sum;
              p.precision = Precision::float_;
            }),
            0x3837bb0f659df27au);
}

TEST(Golden, MeanContacts) {
  EXPECT_EQ(hash_after([](Params& p) { p.contact = ContactRule::mean; }), 0x937cb4eec8c07a3du);
  EXPECT_EQ(hash_after([](Params& p) {
              p.contact = ContactRule::mean;
              p.precision = Precision::float_;
            }),
            0x9de8564ff916b62u);
}

TEST(Golden, BodyHeadingAndEulerHeat) {
  EXPECT_EQ(hash_after([](Params& p) {
              p.heading = Heading::body;
              p.heat = HeatRule::euler;
            }),
            0xa09d33c4bfec3780u);
}

TEST(Golden, RigidPupsOnACarpet) {
  EXPECT_EQ(hash_after([](Params& p) {
              p.rigidity = 1;
              p.deformation = 0;
              p.pups = 40;
              p.start = Start::carpet;
              p.precision = Precision::float_;
            }),
            0x938c6eb4c9484adcu);
}

}  // namespace
}  // namespace pupflow
