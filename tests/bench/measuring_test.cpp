// What pupflow_bench_ratios measures apart from a simulation is what the engine does, and its table
// of aims judges rightly. Times are not looked at.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "bench/litter_state.h"
#include "bench/scenes.h"
#include "bench/verdicts.h"
#include "engine/boundary.h"
#include "engine/contact.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

template <class Real>
void expect_the_contacts_of_a_step(const Params& params) {
  Simulation simulation = settled(params);
  State<Real> state = state_of<Real>(simulation.snapshot());
  ASSERT_TRUE(simulation.step().ok());
  for (int pup = 0; pup < state.pups; ++pup) apply_boundaries(params, state, pup);
  Contacts<Real> contacts;
  Team team;
  contacts.find(params, {}, state, team);
  for (int pup = 0; pup < state.pups; ++pup) {
    EXPECT_TRUE(contacts.apply(params, 1, state, pup, 0).ok());
  }
  EXPECT_GT(state.touching.size(), 3u);
  EXPECT_TRUE(std::ranges::equal(state.touching, simulation.view().touching));
  EXPECT_TRUE(std::ranges::equal(state.touched, simulation.view().touched));
  EXPECT_TRUE(std::ranges::equal(state.exposed, simulation.view().exposed));
}

TEST(Measuring, ContactsOfALitterApartAreThoseOfItsStep) {
  for (ContactRule rule : {ContactRule::nearest, ContactRule::mean, ContactRule::sum}) {
    Params params = huddling(Precision::float_);
    params.contact = rule;
    expect_the_contacts_of_a_step<float>(params);
    params.precision = Precision::double_;
    expect_the_contacts_of_a_step<double>(params);
  }
}

TEST(Measuring, AimsAreReachedOrMissed) {
  Verdicts verdicts;
  verdicts.measured("step in double against the paper's manner", 300);
  verdicts.measured("memory of a pup in float, kB", 40);
  testing::internal::CaptureStdout();
  verdicts.print();
  EXPECT_EQ(testing::internal::GetCapturedStdout(),
            "| target | wanted | measured | | version 0.1.0 |\n|---|---|---|---|---|\n"
            "| memory of a pup in float, kB | ≤ 40 | 40 | reached | 10.29 |\n"
            "| step in double against the paper's manner | ≥ 600 | 300 | missed by a factor of 2 |"
            " 883.2 |\n");
  EXPECT_THROW(verdicts.measured("what nobody aimed at", 1), std::logic_error);
}

}  // namespace
}  // namespace pupflow::bench
