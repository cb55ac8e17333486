// What the plan leaves out, forced in: every reason must be one that changes no bit.
#include <gtest/gtest.h>

#include <bit>
#include <functional>
#include <ostream>

#include "engine/shape_match.h"
#include "pupflow/plan.h"
#include "pupflow/simulation.h"

namespace pupflow {
namespace {

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

void everything(Plan& plan) {
  plan.stages.fill(true);
  plan.parts = PartSet::all();
}

/// Forces one stage, with all parts of it that `which` names.
std::function<void(Plan&)> stage(Stage forced, std::vector<Part> parts = {}) {
  return [=](Plan& plan) {
    plan.add(forced);
    for (const Part part : parts) plan.add(part);
  };
}

std::function<void(Plan&)> part(Part forced) {
  return [=](Plan& plan) { plan.add(forced); };
}

const auto kContact = stage(Stage::contact, {Part::exposure, Part::owners, Part::pairs});
const auto kSteering = stage(Stage::steering, {Part::turn, Part::direction});
const auto kHeat = stage(Stage::heat, {Part::mean_temperature});
const auto kShapeMatch = stage(Stage::shape_match, {Part::rotation});
const auto kAllOfShapeMatch = stage(Stage::shape_match, {Part::rotation, Part::quadratic});

// Every reason of plan.cpp, with the settings that a stage behaves differently under.
const std::vector<Omission> kOmissions{
    {"no_pup", [](Params& p) { p.pups = 0; }, everything},
    {"one_pup_contact", [](Params& p) { p.pups = 1; }, kContact},
    {"one_pup_steering", [](Params& p) { p.pups = 1; }, kSteering},
    {"one_pup_all", [](Params& p) { p.pups = 1; }, everything},
    {"one_pup_by_its_body",
     [](Params& p) {
       p.pups = 1;
       p.heading = Heading::body;
     },
     everything},
    {"no_drive", [](Params& p) { p.drive = 0; }, kSteering, false},
    {"no_drive_by_the_body",
     [](Params& p) {
       p.drive = 0;
       p.heading = Heading::body;
     },
     kSteering, false},
    {"no_sensitivity", [](Params& p) { p.sensitivity = 0; }, kSteering},
    {"no_gain", [](Params& p) { p.steering_gain = 0; }, kSteering},
    {"no_gain_extreme",
     [](Params& p) {
       p.steering_gain = p.air_conductance = p.contact_conductance = p.thermogenesis = 0;
       p.ambient_temperature = -1.7e308;
       p.initial_temperature = 1.7e308;
     },
     kSteering},
    {"no_heat", [](Params& p) { p.air_conductance = p.contact_conductance = p.thermogenesis = 0; },
     kHeat},
    {"no_heat_by_euler",
     [](Params& p) {
       p.air_conductance = p.contact_conductance = p.thermogenesis = 0;
       p.heat = HeatRule::euler;
     },
     kHeat},
    {"no_heat_extreme",
     [](Params& p) {
       p.air_conductance = p.contact_conductance = p.thermogenesis = 0;
       p.ambient_temperature = -1.7e308;
       p.initial_temperature = 1.7e308;
     },
     kHeat},
    {"rigid", [](Params& p) { p.deformation = 0; }, part(Part::quadratic)},
    {"stiff_and_rigid",
     [](Params& p) {
       p.rigidity = 1;
       p.deformation = 0;
     },
     part(Part::quadratic)},
    {"rigid_in_finer_steps",
     [](Params& p) {
       p.deformation = 0;
       p.dt = 0.004;
       p.refinement = Refinement::consistent;
     },
     part(Part::quadratic)},
    {"no_goals_in_finer_steps",
     [](Params& p) {
       p.rigidity = 0;
       p.dt = 0.004;
       p.refinement = Refinement::consistent;
     },
     kAllOfShapeMatch},
    {"no_goals", [](Params& p) { p.rigidity = 0; }, kShapeMatch},
    {"no_goals_quadratic", [](Params& p) { p.rigidity = 0; }, kAllOfShapeMatch},
    {"no_goals_rigid",
     [](Params& p) {
       p.rigidity = 0;
       p.deformation = 0;
     },
     kAllOfShapeMatch},
    {"no_goals_explicit",
     [](Params& p) {
       p.rigidity = 0;
       p.integrator = Integrator::explicit_;
     },
     kAllOfShapeMatch},
    {"nobody_reads_exposure",
     [](Params& p) { p.drive = p.air_conductance = p.contact_conductance = 0; },
     part(Part::exposure)},
    {"nobody_reads_owners", [](Params& p) { p.drive = p.contact_conductance = 0; },
     part(Part::owners)},
    {"nobody_reads_pairs", [](Params&) {}, part(Part::pairs)},
    {"nobody_reads_pairs_of_means", [](Params& p) { p.contact = ContactRule::mean; },
     part(Part::pairs)},
    {"nobody_reads_owners_of_sums",
     [](Params& p) {
       p.drive = p.contact_conductance = 0;
       p.contact = ContactRule::sum;
     },
     part(Part::owners)},
    {"no_sensitivity_by_the_body",
     [](Params& p) {
       p.sensitivity = 0;
       p.heading = Heading::body;
     },
     part(Part::turn)},
    {"no_gain_by_the_body",
     [](Params& p) {
       p.steering_gain = 0;
       p.heading = Heading::body;
     },
     part(Part::turn)},
    {"no_gain_by_the_body_extreme",
     [](Params& p) {
       p.steering_gain = p.air_conductance = p.contact_conductance = p.thermogenesis = 0;
       p.ambient_temperature = -1.7e308;
       p.initial_temperature = 1.7e308;
       p.heading = Heading::body;
     },
     part(Part::turn)},
    {"one_pup_by_its_body_turn",
     [](Params& p) {
       p.pups = 1;
       p.heading = Heading::body;
     },
     part(Part::turn)},
    {"no_heat_between_pups", [](Params& p) { p.contact_conductance = 0; },
     part(Part::mean_temperature)},
    {"no_heat_between_pups_by_euler",
     [](Params& p) {
       p.contact_conductance = 0;
       p.heat = HeatRule::euler;
     },
     part(Part::mean_temperature)},
    {"no_heat_between_pups_extreme",
     [](Params& p) {
       p.contact_conductance = p.thermogenesis = 0;
       p.air_conductance = 1e160;
       p.ambient_temperature = -1.7e308;
       p.initial_temperature = 1.7e308;
     },
     part(Part::mean_temperature)},
    {"one_pup_heat", [](Params& p) { p.pups = 1; }, part(Part::mean_temperature)},
    {"thermogenesis_alone", [](Params& p) { p.air_conductance = p.contact_conductance = 0; },
     part(Part::mean_temperature)},
    {"free", [](Params& p) { p.deformation = 1; }, part(Part::rotation)},
    {"free_and_stiff",
     [](Params& p) {
       p.deformation = 1;
       p.rigidity = 1;
     },
     part(Part::rotation)},
    {"free_in_finer_steps",
     [](Params& p) {
       p.deformation = 1;
       p.dt = 0.004;
       p.refinement = Refinement::consistent;
     },
     part(Part::rotation)},
    {"free_explicit",
     [](Params& p) {
       p.deformation = 1;
       p.rigidity = 0.1;
       p.integrator = Integrator::explicit_;
     },
     part(Part::rotation)},
    {"a_quiet_rigid_litter",
     [](Params& p) {
       p.drive = p.air_conductance = p.contact_conductance = p.thermogenesis = p.deformation = 0;
     },
     everything, false},
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
  p.ambient_temperature = 0.2;
  p.precision = std::get<1>(GetParam());
  omission.edit(p);
  Simulation lean(p), forced(p);
  lean.set_observed({});
  forced.set_observed({});
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
  lean.set_observed({});
  for (int pup = 0; pup < p.pups; ++pup) lean.set_body_temperature(pup, 0.5 - 0.1 * pup);
  Simulation forced(lean);
  Plan more;
  everything(more);
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
  double Params::*const switches[] = {
      &Params::drive,         &Params::air_conductance, &Params::contact_conductance,
      &Params::thermogenesis, &Params::sensitivity,     &Params::steering_gain,
      &Params::rigidity,      &Params::deformation,     &Params::gravity};
  for (int off = 0; off < 1 << std::size(switches); ++off) {
    Params p;
    p.pups = 3;
    p.face_points = 3;
    p.arena_radius = 0.4;  // so small that they fall upon each other
    p.ambient_temperature = 0.2;
    p.heading = off % 2 == 0 ? Heading::course : Heading::body;
    p.precision = off % 3 == 0 ? Precision::float_ : Precision::double_;
    p.refinement = off % 5 == 0 ? Refinement::consistent : Refinement::naive;
    p.dt = off % 5 == 0 ? 0.005 : 0.01;
    for (std::size_t i = 0; i < std::size(switches); ++i) {
      if ((off >> i & 1) != 0) p.*switches[i] = 0;
    }
    if (off % 7 == 0 && p.deformation > 0) p.deformation = 1;
    EXPECT_TRUE(same_bits_when_forced(p, 150)) << "switches off: " << off;
  }
}

// A body at rest in line with the axes has zeros in its fit, of either sign.
TEST(Plan, GoalsOfAFreeBodyHaveTheSameBitsWhateverItsRotation) {
  const Eigen::Matrix3d turned = -Eigen::Matrix3d::Identity();
  for (const double zero : {0.0, -0.0}) {
    ModeMatrix fit = ModeMatrix::Constant(zero);
    fit(0, 1) = fit(1, 2) = 1, fit(2, 3) = -1;
    const ModeMatrix with = goal_modes(fit, turned, 1, 1);
    const ModeMatrix without = goal_modes(fit, Eigen::Matrix3d::Zero(), 1, 1);
    EXPECT_EQ(bits_of({with.data(), 27}), bits_of({without.data(), 27}));
  }
}

}  // namespace
}  // namespace pupflow
