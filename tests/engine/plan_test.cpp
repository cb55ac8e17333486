#include "pupflow/plan.h"

#include <gtest/gtest.h>

#include "pupflow/simulation.h"

namespace pupflow {
namespace {

Plan plan_of(void (*edit)(Params&)) {
  Params p;
  edit(p);
  return make_plan(p, kContactRecords);
}

TEST(Plan, ThePapersLitterNeedsEverything) {
  const Plan plan = make_plan(Params{}, kContactRecords);
  for (const bool needed : plan.stages) EXPECT_TRUE(needed);
  EXPECT_EQ(plan.parts,
            (PartSet{Part::exposure, Part::owners, Part::pairs, Part::turn, Part::direction,
                     Part::mean_temperature, Part::rotation, Part::quadratic}));
}

TEST(Plan, LeavesOutWhatASceneDoesNotNeed) {
  EXPECT_FALSE(plan_of([](Params& p) { p.deformation = 0; }).has(Part::quadratic));
  EXPECT_FALSE(plan_of([](Params& p) { p.deformation = 1; }).has(Part::rotation));
  EXPECT_FALSE(plan_of([](Params& p) { p.contact_conductance = 0; }).has(Part::mean_temperature));
  EXPECT_FALSE(plan_of([](Params& p) { p.rigidity = 0; }).has(Stage::shape_match));
  EXPECT_FALSE(plan_of([](Params& p) { p.pups = 1; }).has(Stage::contact));
  EXPECT_FALSE(plan_of([](Params& p) { p.drive = 0; }).has(Stage::steering));
  EXPECT_FALSE(plan_of([](Params& p) {
                 p.air_conductance = p.contact_conductance = p.thermogenesis = 0;
               }).has(Stage::heat));
  EXPECT_TRUE(
      plan_of([](Params& p) { p.air_conductance = p.contact_conductance = 0; }).has(Stage::heat));
  const Plan nobody = plan_of([](Params& p) { p.pups = 0; });
  for (const bool needed : nobody.stages) EXPECT_FALSE(needed);
  EXPECT_TRUE(nobody.parts.empty());
}

TEST(Plan, WhereNobodyTurnsABodyStillHasADirection) {
  for (double Params::*const cause : {&Params::steering_gain, &Params::sensitivity}) {
    Params p;
    p.*cause = 0;
    EXPECT_FALSE(make_plan(p, kContactRecords).has(Stage::steering));
    p.heading = Heading::body;
    EXPECT_TRUE(make_plan(p, kContactRecords).has(Stage::steering));
    EXPECT_FALSE(make_plan(p, kContactRecords).has(Part::turn));
  }
}

TEST(Plan, ContactsRecordWhatSomebodyReads) {
  struct Case {
    double drive, k1, k2;
    bool observed;
    std::array<bool, 3> expected;  // exposure, owners, pairs
  };
  for (const Case& c : {Case{1, 0.9, 1, true, {true, true, true}},
                        {1, 0.9, 1, false, {true, true, false}},
                        {1, 0, 0, false, {true, true, false}},
                        {0, 0.9, 1, false, {true, true, false}},
                        {0, 0, 1, false, {true, true, false}},
                        {0, 0.9, 0, false, {true, false, false}},
                        {0, 0, 0, false, {false, false, false}},
                        {0, 0, 0, true, {true, true, true}}}) {
    Params p;
    p.drive = c.drive;
    p.air_conductance = c.k1;
    p.contact_conductance = c.k2;
    const Plan plan = make_plan(p, c.observed ? kContactRecords : PartSet{});
    const std::array<bool, 3> found{plan.has(Part::exposure), plan.has(Part::owners),
                                    plan.has(Part::pairs)};
    EXPECT_EQ(found, c.expected) << c.drive << ' ' << c.k1 << ' ' << c.k2 << ' ' << c.observed;
  }
}

TEST(Plan, PartsAreListedInTheOrderOfTheirStages) {
  for (int i = 1; i < kPartCount; ++i) {
    EXPECT_LE(stage_of(static_cast<Part>(i - 1)), stage_of(static_cast<Part>(i)));
    EXPECT_FALSE(part_name(static_cast<Part>(i)).empty());
  }
}

TEST(Plan, EveryDecisionHasAReason) {
  for (const int pups : {0, 1, 12}) {
    for (const double drive : {0.0, 1.0}) {
      Params p;
      p.pups = pups;
      p.drive = drive;
      const Plan plan = make_plan(p, {});
      Plan explained;
      int stages = 0;
      for (const Decision& decision : explain_plan(p, {})) {
        EXPECT_FALSE(decision.reason.empty());
        if (!decision.part) {
          EXPECT_EQ(decision.stage, static_cast<Stage>(stages++));
          if (decision.needed) explained.add(decision.stage);
        } else {
          EXPECT_EQ(decision.stage, stage_of(*decision.part));
          EXPECT_TRUE(plan.has(decision.stage));
          if (decision.needed) explained.add(*decision.part);
        }
      }
      EXPECT_EQ(stages, kStageCount);
      EXPECT_EQ(explained, plan);
    }
  }
}

TEST(Plan, AWholeStageHasThePartsThatTheSceneWouldNeed) {
  Params p;
  p.rigidity = p.deformation = 0;
  const Plan match = whole_stage(Stage::shape_match, p, {});
  EXPECT_TRUE(match.has(Stage::shape_match));
  EXPECT_TRUE(match.has(Part::rotation));
  EXPECT_FALSE(match.has(Part::quadratic));
  EXPECT_FALSE(match.has(Stage::predict));
}

/// Counts how often each stage runs.
struct Counter : StageListener {
  std::array<int, kStageCount> begun{}, ended{};
  void stage_begins(Stage stage) override { ++begun[static_cast<std::size_t>(stage)]; }
  void stage_ends(Stage stage) override { ++ended[static_cast<std::size_t>(stage)]; }
};

TEST(Plan, TheStepRunsThePlanAndNothingElse) {
  Params p;
  p.drive = 0;
  p.air_conductance = p.contact_conductance = p.thermogenesis = 0;
  p.rigidity = 0;
  Simulation s(p);
  Counter counter;
  for (int i = 0; i < 5; ++i) s.step(&counter);
  const std::array<int, kStageCount> expected{5, 5, 0, 0, 5, 0};
  EXPECT_EQ(counter.begun, expected);
  EXPECT_EQ(counter.ended, expected);
}

TEST(Plan, JoinedHasWhatEitherHas) {
  Params p;
  p.drive = p.air_conductance = p.contact_conductance = p.thermogenesis = p.deformation = 0;
  const Plan plan = make_plan(p, {});
  EXPECT_EQ(joined(plan, {}), plan);
  Plan more;
  more.add(Stage::steering);
  more.add(Part::turn);
  more.add(Part::quadratic);
  const Plan both = joined(plan, more);
  EXPECT_TRUE(both.has(Stage::steering));
  EXPECT_TRUE(both.has(Stage::contact));
  EXPECT_FALSE(both.has(Stage::heat));
  EXPECT_TRUE(both.has(Part::quadratic));
  EXPECT_TRUE(both.has(Part::exposure) && both.has(Part::owners)) << "a turn reads them";
  EXPECT_FALSE(both.has(Part::pairs));
}

TEST(Plan, PartsOfAStageThatIsOutAreOutToo) {
  Params p;
  p.pups = 1;
  p.rigidity = 0;
  Plan more;
  for (const Part part : {Part::exposure, Part::owners, Part::pairs, Part::turn, Part::rotation,
                          Part::quadratic, Part::mean_temperature}) {
    if (stage_of(part) != Stage::heat) more.add(part);
  }
  EXPECT_EQ(joined(make_plan(p, kContactRecords), more), make_plan(p, kContactRecords));
}

TEST(Plan, ObservingCanChangeBetweenAnyTwoSteps) {
  Params p;
  p.ambient_temperature = 0.2;
  Simulation watched(p), now_and_then(p);
  for (int step = 0; step < 400; ++step) {
    const bool look = step % 7 == 3 || step % 2 == 0;
    now_and_then.set_observed(look ? kContactRecords : PartSet{});
    EXPECT_EQ(now_and_then.plan().has(Part::pairs), look);
    watched.step();
    now_and_then.step();
    ASSERT_EQ(watched.hash(), now_and_then.hash());
    if (!look) continue;
    const Snapshot a = watched.snapshot(), b = now_and_then.snapshot();
    ASSERT_EQ(a.touching, b.touching) << step;
    ASSERT_EQ(a.touched, b.touched) << step;
    ASSERT_EQ(a.exposed, b.exposed) << step;
  }
  EXPECT_FALSE(watched.view().touching.empty());
}

TEST(Plan, WhatNobodyReadsStaysAsItWas) {
  Params p;
  p.ambient_temperature = 0.2;
  Simulation s(p);
  s.set_observed({});
  s.run(400);
  EXPECT_TRUE(s.view().touching.empty()) << "the list of pairs was made though nobody asked";
  s.set_observed(kContactRecords);
  s.step();
  EXPECT_FALSE(s.view().touching.empty());
}

TEST(Plan, ForcingEndsWithAnEmptyPlanAndOutlivesNewParameters) {
  Params p;
  p.drive = 0;
  Simulation s(p);
  const Plan planned = s.plan();
  Plan more;
  more.add(Stage::steering);
  s.force_plan(more);
  EXPECT_TRUE(s.plan().has(Stage::steering));
  p.ambient_temperature = 0.1;
  s.set_params(p);
  s.set_observed({});
  EXPECT_TRUE(Simulation(s).plan().has(Stage::steering));
  s.set_observed(kContactRecords);
  s.force_plan({});
  EXPECT_EQ(s.plan(), planned);
}

}  // namespace
}  // namespace pupflow
