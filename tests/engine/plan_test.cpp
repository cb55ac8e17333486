#include "engine/plan.h"

#include <gtest/gtest.h>

#include "engine/simulation.h"

namespace pupflow {
namespace {

Plan plan_of(void (*edit)(Params&)) {
  Params p;
  edit(p);
  return make_plan(p, true);
}

TEST(Plan, ThePapersLitterNeedsEverything) {
  const Plan plan = make_plan(Params{}, true);
  for (const bool needed : plan.needed) EXPECT_TRUE(needed);
  EXPECT_TRUE(plan.quadratic);
  EXPECT_TRUE(plan.afferents);
}

TEST(Plan, LeavesOutWhatASceneDoesNotNeed) {
  EXPECT_FALSE(plan_of([](Params& p) { p.beta = 0; }).quadratic);
  EXPECT_FALSE(plan_of([](Params& p) { p.alpha = 0; }).has(Stage::shape_match));
  EXPECT_FALSE(plan_of([](Params& p) { p.pups = 1; }).has(Stage::contact));
  EXPECT_FALSE(plan_of([](Params& p) { p.drive = 0; }).has(Stage::steering));
  EXPECT_FALSE(plan_of([](Params& p) { p.k1 = p.k2 = p.g = 0; }).has(Stage::heat));
  EXPECT_TRUE(plan_of([](Params& p) { p.k1 = p.k2 = 0; }).has(Stage::heat));
  const Plan nobody = plan_of([](Params& p) { p.pups = 0; });
  for (const bool needed : nobody.needed) EXPECT_FALSE(needed);
}

TEST(Plan, AfferentsAreRecordedOnlyForThoseWhoAsk) {
  Params p;
  p.drive = p.k1 = p.k2 = 0;
  EXPECT_TRUE(make_plan(p, true).afferents);
  EXPECT_FALSE(make_plan(p, false).afferents);
}

TEST(Plan, EveryStageHasAReason) {
  for (const int pups : {0, 1, 12}) {
    for (const double drive : {0.0, 1.0}) {
      Params p;
      p.pups = pups;
      p.drive = drive;
      const auto stages = explain_plan(p, false);
      const Plan plan = make_plan(p, false);
      ASSERT_EQ(stages.size(), static_cast<std::size_t>(kStageCount));
      for (const PlannedStage& stage : stages) {
        EXPECT_FALSE(stage.reason.empty());
        EXPECT_EQ(stage.needed, plan.has(stage.stage));
      }
    }
  }
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
  p.k1 = p.k2 = p.g = 0;
  p.alpha = 0;
  Simulation s(p);
  Counter counter;
  for (int i = 0; i < 5; ++i) s.step(&counter);
  const std::array<int, kStageCount> expected{5, 5, 0, 0, 5, 0};
  EXPECT_EQ(counter.begun, expected);
  EXPECT_EQ(counter.ended, expected);
}

TEST(Plan, LeavingOutTheObserverChangesNoBit) {
  Params p;
  p.drive = p.k1 = p.k2 = 0;
  Simulation watched(p), alone(p);
  alone.set_observed(false);
  watched.run(400);
  alone.run(400);
  EXPECT_FALSE(alone.plan().afferents);
  EXPECT_EQ(watched.hash(), alone.hash());
}

}  // namespace
}  // namespace pupflow
