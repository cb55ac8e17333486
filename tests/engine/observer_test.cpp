#include "pupflow/observer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pupflow/geometry.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

TEST(Groups, AreConnectedComponents) {
  const std::vector<TouchingPair> touching{{0, 3}, {1, 4}, {3, 5}};
  EXPECT_EQ(group_labels(6, touching), (std::vector<int>{0, 1, 2, 0, 1, 0}));
  EXPECT_EQ(group_labels(3, {}), (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(group_labels(0, {}).empty());
}

/// Three pups in a row on the floor, the second touching the first, the third far away.
struct RowOfThree : ::testing::Test {
  RowOfThree() : simulation(make()) { put(0, 0), put(1, 0.58), put(2, 1.5); }
  static Params make() {
    Params p = testing::weightless();
    p.pups = 3;
    return p;
  }
  void put(int pup, double x) {
    testing::Points points;
    for (const auto& q : cube_sphere(7, 0.25)) points.push_back(q + Eigen::Vector3d(x, 0, 1));
    testing::place(simulation, pup, points,
                   testing::Points(points.size(), Eigen::Vector3d::Zero()));
  }
  Simulation simulation;
};

TEST_F(RowOfThree, ObservablesAreCountedRight) {
  simulation.set_body_temperature(0, 0.9);
  Observer observer(simulation);
  simulation.step();
  const Observables& now = observer.observe(simulation);
  const auto exposed = simulation.view().exposed;
  EXPECT_LT(exposed[0], 1);
  EXPECT_EQ(exposed[2], 1);
  EXPECT_DOUBLE_EQ(now.huddling, 1 - (exposed[0] + exposed[1] + 1) / 3);
  EXPECT_EQ(now.groups, 2);
  EXPECT_EQ(now.largest, 2);
  const auto tb = simulation.view().tb;
  EXPECT_DOUBLE_EQ(now.mean_tb, (tb[0] + tb[1] + tb[2]) / 3);
  EXPECT_NEAR(now.flow, ((1 - exposed[0]) + (1 - exposed[1])) / 3 / 0.01, 1e-12);
  EXPECT_DOUBLE_EQ(now.membership_flow, 2 / (3 * 0.01));  // two pups found each other
}

TEST_F(RowOfThree, MembershipFlowCountsThoseWhoseMatesChanged) {
  Observer observer(simulation);
  simulation.step();
  observer.observe(simulation);
  put(0, 0), put(1, 0.75), put(2, 0.75 + 0.58);  // the second changes sides: all three see a change
  simulation.step();
  EXPECT_DOUBLE_EQ(observer.observe(simulation).membership_flow, 3 / (3 * 0.01));
  put(0, 0), put(1, 0.75), put(2, 0.75 + 0.58);
  simulation.step();
  EXPECT_EQ(observer.observe(simulation).membership_flow, 0);
}

TEST_F(RowOfThree, FlowComparesOverItsLag) {
  Params lagged = simulation.params();
  lagged.flow_lag = 3;
  simulation.set_params(lagged);
  Observer every(simulation), sparing(simulation);
  std::vector<std::vector<double>> exposed{{1, 1, 1}};  // by step
  for (int step = 1; step <= 9; ++step) {
    put(0, 0), put(1, 0.58 - 0.003 * step * step), put(2, 1.5);  // ever deeper
    simulation.step();
    exposed.emplace_back(simulation.view().exposed.begin(), simulation.view().exposed.end());
    const double flow = every.observe(simulation).flow;
    if (step < 3) {
      EXPECT_TRUE(std::isnan(flow)) << step;
    } else {
      double change = 0;
      for (int pup = 0; pup < 3; ++pup)
        change += std::abs(exposed[step][pup] - exposed[step - 3][pup]);
      EXPECT_GT(change, 0) << step;
      EXPECT_NEAR(flow, change / 3 / (3 * 0.01), 1e-12) << step;
    }
    if (step % 4 != 0) {
      sparing.pass(simulation);  // what nobody looks at is compared with nevertheless
    } else {
      const Observables& seen = sparing.observe(simulation);
      EXPECT_EQ(seen.flow, flow) << step;
      EXPECT_EQ(seen.membership_flow, every.last().membership_flow) << step;
    }
  }
}

TEST_F(RowOfThree, FlowOverALagIsTheChangeOfAOverItsTime) {
  Params lagged = simulation.params();
  lagged.flow_lag = 5;
  simulation.set_params(lagged);
  Observer observer(simulation);
  for (int step = 1; step <= 4; ++step) {
    simulation.step();
    observer.pass(simulation);
  }
  simulation.step();
  const auto a = simulation.view().exposed;  // from 1 at the start
  EXPECT_NEAR(observer.observe(simulation).flow, (3 - a[0] - a[1] - a[2]) / 3 / 0.05, 1e-12);
}

TEST_F(RowOfThree, OnlyWhatIsWantedIsComputed) {
  for (const ObservableField& row : observables()) {
    Observer all(simulation);
    Observer one(simulation, ObservableSet().add(row.observable));
    simulation.step();
    const Observables &whole = all.observe(simulation), &part = one.observe(simulation);
    for (const ObservableField& other : observables()) {
      if (other.observable == row.observable) {
        EXPECT_EQ(part.*other.value, whole.*other.value) << other.name;
      } else {
        EXPECT_TRUE(std::isnan(part.*other.value)) << other.name;
      }
    }
  }
}

TEST_F(RowOfThree, TheMeanOfTheFlowIsOverTheStepsThatHaveOne) {
  Params lagged = simulation.params();
  lagged.flow_lag = 4;
  simulation.set_params(lagged);
  Observer observer(simulation);
  RunMeans means(0);
  double sum = 0;
  for (int step = 1; step <= 10; ++step) {
    simulation.step();
    const Observables& now = observer.observe(simulation);
    means.add(simulation, now);
    if (step >= 4) sum += now.flow;
  }
  EXPECT_EQ(means.count(), 10);
  EXPECT_DOUBLE_EQ(means.means().flow, sum / 7);
}

TEST(Observer, TheTableOfNamesIsThatOfTheEnum) {
  for (std::size_t i = 0; i < kObservableCount; ++i)
    EXPECT_EQ(static_cast<std::size_t>(observables()[i].observable), i);
}

TEST_F(RowOfThree, RunMeansLeaveOutTheDiscardedSteps) {
  Observer observer(simulation);
  RunMeans means(3);
  double tb = 0;
  std::vector<double> exposed;
  for (int i = 0; i < 10; ++i) {
    simulation.step();
    const Observables& now = observer.observe(simulation);
    means.add(simulation, now);
    if (i < 3) continue;
    tb += now.mean_tb / 7;
    exposed.push_back(simulation.view().exposed[0]);
  }
  EXPECT_EQ(means.count(), 7);
  EXPECT_NEAR(means.means().mean_tb, tb, 1e-14);
  double mean = 0, m2 = 0;
  for (const double a : exposed) mean += a / 7;
  for (const double a : exposed) m2 += (a - mean) * (a - mean) / 6;
  EXPECT_GE(means.exposed_sd(), std::sqrt(m2) / 3 - 1e-12);
}

TEST(RunMeans, WithoutStepsAreNotANumber) {
  const RunMeans means(5);
  EXPECT_TRUE(std::isnan(means.means().mean_tb));
  EXPECT_TRUE(std::isnan(means.exposed_sd()));
}

TEST(Observer, AnEmptyLitterHasNothingToShow) {
  Params p;
  p.pups = 0;
  Simulation s(p);
  Observer observer(s);
  EXPECT_TRUE(s.run(10).ok());
  EXPECT_EQ(observer.observe(s).groups, 0);
}

}  // namespace
}  // namespace pupflow
