// The paper's result in small: huddling in the cold, dispersal in the warm.
#include <gtest/gtest.h>

#include "pupflow/observer.h"
#include "pupflow/simulation.h"

namespace pupflow {
namespace {

/// Means over steps 500-1500, averaged over seeds 1-10.
Observables mean_over_seeds(double ta, Precision precision) {
  Observables sum;
  for (int seed = 1; seed <= 10; ++seed) {
    Params p;
    p.ambient_temperature = ta;
    p.seed = seed;
    p.precision = precision;
    Simulation s(p);
    Observer observer(s);
    RunMeans means(p.discard);
    for (int i = 0; i < p.steps; ++i) {
      EXPECT_TRUE(s.step().ok());
      means.add(s, observer.observe(s));
    }
    sum.groups += means.means().groups / 10;
    sum.huddling += means.means().huddling / 10;
    sum.mean_tb += means.means().mean_tb / 10;
  }
  return sum;
}

class Transition : public ::testing::TestWithParam<Precision> {};

TEST_P(Transition, PupsHuddleInTheColdAndDisperseInTheWarm) {
  const Observables cold = mean_over_seeds(0.2, GetParam());
  const Observables warm = mean_over_seeds(0.8, GetParam());
  EXPECT_LE(cold.groups, 5.5);
  EXPECT_GE(warm.groups, 6);
  EXPECT_GT(cold.huddling, 0.45);
  EXPECT_LT(warm.huddling, 0.25);
  EXPECT_GT(cold.mean_tb, 0.2 + 0.12);  // an isolated pup settles at T_a + 0.0611
  EXPECT_GT(warm.mean_tb, 0.8 + 0.06);
}

INSTANTIATE_TEST_SUITE_P(Precisions, Transition,
                         ::testing::Values(Precision::float_, Precision::double_));

}  // namespace
}  // namespace pupflow
