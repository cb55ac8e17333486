#include "engine/plan.h"

#include <gtest/gtest.h>

#include <bit>
#include <functional>
#include <ostream>

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

TEST(Plan, JoinedHasWhatEitherHas) {
  Params p;
  p.drive = p.k1 = p.k2 = p.g = p.beta = 0;
  const Plan plan = make_plan(p, false);
  EXPECT_EQ(joined(plan, {}), plan);
  Plan more;
  more.add(Stage::steering);
  more.quadratic = true;
  const Plan both = joined(plan, more);
  EXPECT_TRUE(both.has(Stage::steering));
  EXPECT_TRUE(both.has(Stage::contact));
  EXPECT_FALSE(both.has(Stage::heat));
  EXPECT_TRUE(both.quadratic);
  EXPECT_TRUE(both.afferents) << "steering reads them";
}

TEST(Plan, PartsOfAStageThatIsOutAreOutToo) {
  Params p;
  p.pups = 1;
  p.alpha = 0;
  Plan more;
  more.quadratic = more.afferents = true;
  EXPECT_EQ(joined(make_plan(p, true), more), make_plan(p, true));
}

/// A reason to leave something out, and what to force in against it.
struct Omission {
  const char* name;
  std::function<void(Params&)> edit;
  std::function<void(Plan&)> force;
  bool headings = true;  // whether headings must agree too
};

void PrintTo(const Omission& omission, std::ostream* out) {
  *out << omission.name;
}

void all_stages(Plan& plan) {
  plan.needed.fill(true);
  plan.quadratic = plan.afferents = true;
}
void contact(Plan& plan) {
  plan.add(Stage::contact);
  plan.afferents = true;
}
void steering(Plan& plan) {
  plan.add(Stage::steering);
}
void heat(Plan& plan) {
  plan.add(Stage::heat);
}
void quadratic(Plan& plan) {
  plan.quadratic = true;
}
void shape_match(Plan& plan) {
  plan.add(Stage::shape_match);
}
void all_of_shape_match(Plan& plan) {
  plan.add(Stage::shape_match);
  plan.quadratic = true;
}

// Every reason of plan.cpp, with the settings that a stage behaves differently under.
const std::vector<Omission> kOmissions{
    {"no_pup", [](Params& p) { p.pups = 0; }, all_stages},
    {"one_pup_contact", [](Params& p) { p.pups = 1; }, contact},
    {"one_pup_steering", [](Params& p) { p.pups = 1; }, steering},
    {"one_pup_all", [](Params& p) { p.pups = 1; }, all_stages},
    {"one_pup_by_its_body",
     [](Params& p) {
       p.pups = 1;
       p.heading = Heading::body;
     },
     all_stages},
    {"no_drive", [](Params& p) { p.drive = 0; }, steering, false},
    {"no_drive_by_the_body",
     [](Params& p) {
       p.drive = 0;
       p.heading = Heading::body;
     },
     steering, false},
    {"no_sensitivity", [](Params& p) { p.sigma = 0; }, steering},
    {"no_gain", [](Params& p) { p.v = 0; }, steering},
    {"no_gain_extreme",
     [](Params& p) {
       p.v = p.k1 = p.k2 = p.g = 0;
       p.ta = -1.7e308;
       p.tb0 = 1.7e308;
     },
     steering},
    {"no_heat", [](Params& p) { p.k1 = p.k2 = p.g = 0; }, heat},
    {"no_heat_by_euler",
     [](Params& p) {
       p.k1 = p.k2 = p.g = 0;
       p.heat = HeatRule::euler;
     },
     heat},
    {"no_heat_extreme",
     [](Params& p) {
       p.k1 = p.k2 = p.g = 0;
       p.ta = -1.7e308;
       p.tb0 = 1.7e308;
     },
     heat},
    {"rigid", [](Params& p) { p.beta = 0; }, quadratic},
    {"stiff_and_rigid",
     [](Params& p) {
       p.alpha = 1;
       p.beta = 0;
     },
     quadratic},
    {"rigid_in_finer_steps",
     [](Params& p) {
       p.beta = 0;
       p.dt = 0.004;
       p.refinement = Refinement::consistent;
     },
     quadratic},
    {"no_goals_in_finer_steps",
     [](Params& p) {
       p.alpha = 0;
       p.dt = 0.004;
       p.refinement = Refinement::consistent;
     },
     all_of_shape_match},
    {"no_goals", [](Params& p) { p.alpha = 0; }, shape_match},
    {"no_goals_quadratic", [](Params& p) { p.alpha = 0; }, all_of_shape_match},
    {"no_goals_rigid",
     [](Params& p) {
       p.alpha = 0;
       p.beta = 0;
     },
     all_of_shape_match},
    {"no_goals_explicit",
     [](Params& p) {
       p.alpha = 0;
       p.integrator = Integrator::explicit_;
     },
     all_of_shape_match},
    {"nobody_asks_who_touches", [](Params& p) { p.drive = p.k1 = p.k2 = 0; },
     [](Plan& plan) { plan.afferents = true; }},
    {"a_quiet_rigid_litter", [](Params& p) { p.drive = p.k1 = p.k2 = p.g = p.beta = 0; },
     all_stages, false},
};

std::vector<std::uint64_t> bits_of(std::span<const double> values) {
  std::vector<std::uint64_t> bits;
  bits.reserve(values.size());
  for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
  return bits;
}

struct Forced : testing::TestWithParam<std::tuple<Omission, Precision>> {};

TEST_P(Forced, StagesThatAreLeftOutWouldChangeNoBit) {
  const Omission& omission = std::get<0>(GetParam());
  Params p;
  p.ta = 0.2;
  p.precision = std::get<1>(GetParam());
  omission.edit(p);
  Simulation lean(p), forced(p);
  lean.set_observed(false);
  forced.set_observed(false);
  Plan more;
  omission.force(more);
  forced.force_plan(more);
  ASSERT_NE(forced.plan(), lean.plan()) << "nothing was forced";
  for (int round = 0; round < 40; ++round) {
    lean.run(10);
    forced.run(10);
    ASSERT_EQ(lean.steps_done(), forced.steps_done());
    ASSERT_EQ(lean.status().ok(), forced.status().ok()) << forced.status().message();
    const Snapshot a = lean.snapshot(), b = forced.snapshot();
    ASSERT_EQ(bits_of(a.positions), bits_of(b.positions)) << "by step " << lean.steps_done();
    ASSERT_EQ(bits_of(a.velocities), bits_of(b.velocities)) << "by step " << lean.steps_done();
    ASSERT_EQ(bits_of(a.body_temperature), bits_of(b.body_temperature));
    if (omission.headings) {
      ASSERT_EQ(lean.hash(), forced.hash());
    }
  }
}

std::string name_of(const testing::TestParamInfo<Forced::ParamType>& info) {
  const bool single = std::get<1>(info.param) == Precision::float_;
  return std::string(std::get<0>(info.param).name) + (single ? "_float" : "_double");
}

INSTANTIATE_TEST_SUITE_P(Plan, Forced,
                         testing::Combine(testing::ValuesIn(kOmissions),
                                          testing::Values(Precision::float_, Precision::double_)),
                         name_of);

/// Whether a litter with everything forced in has the bits of the same litter as planned, headings
/// aside where nothing reads them.
bool same_bits_when_forced(const Params& p, int steps) {
  Simulation lean(p);
  lean.set_observed(false);
  for (int pup = 0; pup < p.pups; ++pup) lean.set_body_temperature(pup, 0.5 - 0.1 * pup);
  Simulation forced(lean);
  Plan more;
  all_stages(more);
  forced.force_plan(more);
  lean.run(steps);
  forced.run(steps);
  if (p.drive > 0) return lean.hash() == forced.hash();
  const Snapshot a = lean.snapshot(), b = forced.snapshot();
  return bits_of(a.positions) == bits_of(b.positions) &&
         bits_of(a.velocities) == bits_of(b.velocities) &&
         bits_of(a.body_temperature) == bits_of(b.body_temperature);
}

TEST(Plan, WhateverIsSwitchedOffLeavingOutChangesNoBit) {
  double Params::*const switches[] = {&Params::drive, &Params::k1,    &Params::k2,
                                      &Params::g,     &Params::sigma, &Params::v,
                                      &Params::alpha, &Params::beta,  &Params::gravity};
  for (int off = 0; off < 1 << std::size(switches); ++off) {
    Params p;
    p.pups = 3;
    p.face_points = 3;
    p.arena_radius = 0.4;  // so small that they fall upon each other
    p.ta = 0.2;
    p.heading = off % 2 == 0 ? Heading::course : Heading::body;
    p.precision = off % 3 == 0 ? Precision::float_ : Precision::double_;
    p.refinement = off % 5 == 0 ? Refinement::consistent : Refinement::naive;
    p.dt = off % 5 == 0 ? 0.005 : 0.01;
    for (std::size_t i = 0; i < std::size(switches); ++i) {
      if ((off >> i & 1) != 0) p.*switches[i] = 0;
    }
    EXPECT_TRUE(same_bits_when_forced(p, 150)) << "switches off: " << off;
  }
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
  p.ta = 0.1;
  s.set_params(p);
  s.set_observed(false);
  EXPECT_TRUE(Simulation(s).plan().has(Stage::steering));
  s.set_observed(true);
  s.force_plan({});
  EXPECT_EQ(s.plan(), planned);
}

}  // namespace
}  // namespace pupflow
