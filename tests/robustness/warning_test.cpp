// Impossible states are reported, once each; ordinary litters get no warning.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

using testing::Points;
using Kind = Warning::Kind;

std::string text_of(const Simulation& s) {
  return warnings_text(s.warnings());
}

/// The warning of this kind; one at step 0 when there is none.
Warning first(const Simulation& s, Kind kind) {
  for (const Warning& warning : s.warnings()) {
    if (warning.kind == kind) return warning;
  }
  return {};
}

Params ten_times() {
  Params p;
  for (double* value :
       {&p.arena_radius, &p.pup_radius, &p.point_radius, &p.start_spread, &p.gravity, &p.drive}) {
    *value *= 10;
  }
  return p;
}

/// Moves a pup as it is.
void shift(Simulation& s, int pup, const Eigen::Vector3d& by, const Eigen::Vector3d& velocity) {
  Points x = testing::of_pup(s, pup, testing::all_positions(s));
  for (Eigen::Vector3d& point : x) point += by;
  testing::place(s, pup, x, Points(x.size(), velocity));
}

TEST(Warnings, NameKindStepAndPupWithoutCommas) {
  const Warning warning{Kind::hanging, 812, 3};
  EXPECT_EQ(warning.message(), "hanging in the air from step 812 pup 3");
  EXPECT_EQ(warnings_text({}), "");
  const std::array<Warning, 2> both{Warning{Kind::sunk, 7, 0}, warning};
  EXPECT_EQ(warnings_text(both),
            "under the floor from step 7 pup 0; hanging in the air from step 812 pup 3");
}

TEST(Warnings, KeepTheFirstOfAKind) {
  Warnings warnings;
  warnings.add({Kind::outside, 5, 1});
  warnings.add({Kind::outside, 6, 2});
  warnings.add({Kind::sunk, 7, 2});
  ASSERT_EQ(warnings.all().size(), 2u);
  EXPECT_EQ(warnings.all()[0].step, 5);
  EXPECT_EQ(warnings.all()[1].kind, Kind::sunk);
}

// g h^2 = 0.1: in one step a body falls by more than what the floor lifts it.
TEST(Warnings, AStepTooLongForGravityHoldsPupsUnderTheFloor) {
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    Params heavy, coarse;
    heavy.precision = coarse.precision = precision;
    heavy.gravity = 1000;
    coarse.dt = 0.1;
    for (const Params& p : {heavy, coarse}) {
      Simulation s(p);
      EXPECT_TRUE(s.run(300).ok());
      const Warning warning = first(s, Kind::sunk);
      EXPECT_GT(warning.step, 0);
      Simulation again(p);
      int under = 0;
      for (int step = 1; step <= 300; ++step) {
        again.step();
        under += again.view().positions.mean(warning.pup).z() < 0 ? 1 : 0;
      }
      EXPECT_GT(under, 50);
    }
  }
}

TEST(Warnings, ADriveThatPressesPupsThroughTheWallLeavesThemOutsideAndHanging) {
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    Params p;
    p.precision = precision;
    p.drive = 60;
    Simulation s(p);
    EXPECT_TRUE(s.run(200).ok());
    const Warning outside = first(s, Kind::outside), hanging = first(s, Kind::hanging);
    ASSERT_GT(outside.step, 0);
    ASSERT_GT(hanging.step, 0);
    EXPECT_GT(s.view().positions.mean(outside.pup).head<2>().norm(), p.arena_radius);
    const double height = s.view().positions.mean(hanging.pup).z();
    EXPECT_GT(height, 3 * p.pup_radius);
    s.run(100);
    EXPECT_LT(height - s.view().positions.mean(hanging.pup).z(), 0.5);  // 5 in free fall from rest
  }
}

// Pups of radius 2.5 at a spacing of 1, as a column once had them: displacements by contact are
// lengths squared.
TEST(Warnings, PupsThatClimbWithoutInputGainEnergy) {
  Params p = ten_times();
  p.contact = ContactRule::sum;
  Simulation s(p);
  for (int pup = 0; pup < s.pups(); ++pup) {
    shift(s, pup, {0, 0, -5.0 * pup}, Eigen::Vector3d::Zero());
  }
  EXPECT_TRUE(s.run(800).ok());
  const Warning warning = first(s, Kind::gaining_energy);
  EXPECT_GT(warning.step, 0);
  EXPECT_GT(s.view().positions.mean(warning.pup).z(), 100);  // the highest began at 14
}

TEST(Warnings, TheUndampedFormGainsEnergyBeforeItDiverges) {
  Params p;
  p.pups = 1;
  p.deformation = 0;
  p.integrator = Integrator::explicit_;
  Simulation s(p);
  EXPECT_FALSE(s.run(1000).ok());
  ASSERT_EQ(s.warnings().size(), 1u);
  EXPECT_EQ(s.warnings()[0].kind, Kind::gaining_energy);
  EXPECT_LT(s.warnings()[0].step, s.status().step);
}

TEST(Warnings, AreInTheOrderOfSteps) {
  Params p = ten_times();
  p.contact = ContactRule::sum;
  p.face_points = 4;
  for (double* value : {&p.arena_radius, &p.pup_radius, &p.point_radius, &p.gravity, &p.drive}) {
    *value *= 5;
  }
  Simulation s(p);
  s.run(1000);
  ASSERT_GE(s.warnings().size(), 2u);
  for (std::size_t i = 1; i < s.warnings().size(); ++i) {
    EXPECT_LE(s.warnings()[i - 1].step, s.warnings()[i].step);
    EXPECT_NE(s.warnings()[i - 1].kind, s.warnings()[i].kind);
  }
}

TEST(Warnings, StayWithACopyAndWithChangedParametersButNotInASnapshot) {
  Params p;
  p.drive = 60;
  Simulation s(p);
  s.run(300);
  const std::string text = text_of(s);
  EXPECT_NE(text, "");
  Simulation copy = s;
  EXPECT_EQ(text_of(copy), text);
  p.drive = 1;
  copy.set_params(p);
  copy.run(5);
  EXPECT_EQ(text_of(copy), text);
  Simulation restored(s.snapshot());
  EXPECT_EQ(text_of(restored), "");
  restored.run(200);
  EXPECT_THAT(text_of(restored), ::testing::HasSubstr("hanging in the air from step 4"));
}

TEST(Warnings, AreTheSameForAnyNumberOfThreads) {
  Params p;
  p.pups = 100;
  p.face_points = 3;
  p.drive = 60;
  Simulation one(p), four(p);
  four.set_threads(4);
  one.run(300);
  four.run(300);
  EXPECT_NE(text_of(one), "");
  EXPECT_EQ(text_of(one), text_of(four));
}

TEST(Warnings, FlightIsNoHanging) {
  Params p;
  p.pups = 1;
  p.drive = 0;
  for (const double speed : {0.5, 2.0, 8.0, 20.0}) {
    Simulation s(p);
    shift(s, 0, {0, 0, 3}, {0, 0, speed});  // up for speed / 10 seconds
    EXPECT_TRUE(s.run(1500).ok());
    EXPECT_EQ(text_of(s), "") << speed;
  }
}

TEST(Warnings, HardLandingsAreNoSinking) {
  int under = 0;
  for (const double alpha : {0.0, 0.05, 0.7, 1.0}) {
    for (const double height : {400.0, 600.0, 1000.0}) {  // lands with about 1 a step
      Params p;
      p.pups = 1;
      p.drive = 0;
      p.rigidity = alpha;
      Simulation s(p);
      shift(s, 0, {0, 0, height}, Eigen::Vector3d::Zero());
      for (int step = 0; step < 4000; ++step) {
        EXPECT_TRUE(s.step().ok());
        under += s.view().positions.mean(0).z() < 0 ? 1 : 0;
      }
      EXPECT_EQ(first(s, Kind::sunk).step, 0) << alpha << ' ' << height;
      EXPECT_EQ(first(s, Kind::hanging).step, 0) << alpha << ' ' << height;
    }
  }
  EXPECT_GT(under, 5);
}

// Landing with 0.41, most of its size, in a step, a pup bounces higher than it fell from.
TEST(Warnings, AFallTooFastForTheStepGainsEnergy) {
  Params p;
  p.pups = 1;
  p.drive = 0;
  Simulation s(p);
  shift(s, 0, {0, 0, 84}, Eigen::Vector3d::Zero());
  double highest = 0;
  for (int step = 0; step < 2500; ++step) {
    s.step();
    highest = std::max(highest, s.view().positions.mean(0).z());
  }
  EXPECT_GT(highest, 1.5 * 84.3);
  EXPECT_GT(first(s, Kind::gaining_energy).step, 411);  // the first landing
}

TEST(Warnings, WithoutGravityNothingHangs) {
  Params p;
  p.gravity = 0;
  Simulation s(p);
  EXPECT_TRUE(s.run(1500).ok());
  EXPECT_EQ(text_of(s), "");
}

// Points so large that pups touch over a gap wider than a pup radius. Nobody observes `unseen`, so
// its contacts do not list who touches whom.
TEST(Warnings, AreTheSameWhetherOrNotTheLitterIsObserved) {
  for (const double point_radius : {0.2, 0.3, 0.5}) {
    Params p;
    p.face_points = 3;
    p.point_radius = point_radius;
    Simulation seen(p), unseen(p);
    unseen.set_observed({});
    seen.run(600);
    unseen.run(600);
    EXPECT_EQ(text_of(seen), "") << point_radius;
    EXPECT_EQ(text_of(unseen), "") << point_radius;
  }
}

void expect_none(const char* what, std::int64_t steps, void (*edit)(Params&)) {
  Params p;
  edit(p);
  Simulation s(p);
  EXPECT_TRUE(s.run(steps).ok()) << what;
  EXPECT_EQ(text_of(s), "") << what;
}

TEST(Warnings, AreNotGivenToThePapersLitters) {
  for (const double ta : {0.2, 0.5, 0.8}) {
    for (const Heading heading : {Heading::course, Heading::body}) {
      for (const ContactRule contact :
           {ContactRule::nearest, ContactRule::mean, ContactRule::sum}) {
        Params p;
        p.ambient_temperature = ta;
        p.heading = heading;
        p.contact = contact;
        Simulation s(p);
        EXPECT_TRUE(s.run(1500).ok());
        EXPECT_EQ(text_of(s), "") << ta;
      }
    }
  }
}

TEST(Warnings, AreNotGivenToOrdinaryLitters) {
  expect_none("ten times as large", 1500, [](Params& p) { p = ten_times(); });
  expect_none("loose", 1500, [](Params& p) { p.rigidity = 0; });
  expect_none("soft", 1500, [](Params& p) { p.rigidity = 0.1; });
  expect_none("rigid", 1500, [](Params& p) { p.rigidity = 1, p.deformation = 0; });
  expect_none("puddles", 1500, [](Params& p) { p.deformation = 1; });
  expect_none("k = 2", 1500, [](Params& p) { p.face_points = 2; });
  expect_none("k = 12", 500, [](Params& p) { p.face_points = 12; });
  expect_none("small step", 3000, [](Params& p) { p.dt = 0.002, p.face_points = 4; });
  expect_none("large step", 1500, [](Params& p) { p.dt = 0.05; });
  expect_none("strong drive", 1500, [](Params& p) { p.drive = 10; });
  expect_none("heavy", 1500, [](Params& p) { p.gravity = 100; });
  expect_none("no heat", 1500,
              [](Params& p) { p.air_conductance = p.contact_conductance = p.thermogenesis = 0; });
  expect_none("small arena", 1500, [](Params& p) { p.arena_radius = 0.6, p.pups = 30; });
  expect_none("wide points", 1500, [](Params& p) { p.point_radius = 0.2; });
}

TEST(Warnings, AreNotGivenToPilesAndCarpets) {
  expect_none("pile", 2000, [](Params& p) {
    p.pups = 200;
    p.ambient_temperature = 0.2;
    p.face_points = 4;
    p.precision = Precision::float_;
  });
  expect_none("stacked carpet", 1000, [](Params& p) {
    p.pups = 200;
    p.start = Start::carpet;
    p.face_points = 4;
  });
  expect_none("wide carpet", 300, [](Params& p) {
    p.pups = 1000;
    p.start = Start::carpet;
    p.arena_radius = 18.26;
    p.face_points = 4;
  });
}

}  // namespace
}  // namespace pupflow
