// The baselines step the model that the engine steps, written down a second and a third time: so
// they are fair to measure against, and predict what the engine must come to.
#include <gtest/gtest.h>

#include <cmath>

#include "bench/paper_manner.h"
#include "bench/plain_eigen.h"
#include "pupflow/simulation.h"

namespace pupflow::bench {
namespace {

PaperManner all_pairs(const Snapshot& s) {
  return {s, PairSearch::vectors};
}
PaperManner by_element(const Snapshot& s) {
  return {s, PairSearch::elements};
}
PaperManner with_bounds(const Snapshot& s) {
  return {s, PairSearch::bounds};
}
PlainEigen<double> eigen(const Snapshot& s) {
  return PlainEigen<double>(s);
}
PlainEigen<float> eigen_in_float(const Snapshot& s) {
  return PlainEigen<float>(s);
}

/// A litter that huddles: twelve pups, many of which touch each other, the floor and the wall.
Simulation huddle(Precision precision) {
  Params params;
  params.ambient_temperature = 0.2;
  params.precision = precision;
  Simulation simulation(params);
  EXPECT_TRUE(simulation.run(500).ok());
  return simulation;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected,
                 double tolerance, const char* what) {
  ASSERT_EQ(found.size(), expected.size()) << what;
  double worst = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    worst = std::max(worst, std::abs(found[i] - expected[i]));
  }
  EXPECT_LE(worst, tolerance) << what;
}

/// Tolerances of positions; velocities are differences of positions through h = 0.01.
void expect_same(const Outcome& found, const Simulation& engine, double tolerance) {
  const Snapshot expected = engine.snapshot();
  EXPECT_GT(expected.touching.size(), 5u);
  EXPECT_EQ(found.touching, expected.touching);
  expect_near(found.positions, expected.positions, tolerance, "positions");
  expect_near(found.velocities, expected.velocities, 100 * tolerance, "velocities");
  expect_near(found.exposed, expected.exposed, 1e-12, "exposed shares");
  expect_near(found.body_temperature, expected.body_temperature, 1e-12, "body temperatures");
  expect_near(found.heading, expected.heading, 1e3 * tolerance, "headings");
}

/// Goes on for `steps` steps in both, in double.
template <class MakeBaseline>
void expect_the_same_course(MakeBaseline make, int steps) {
  Simulation engine = huddle(Precision::double_);
  auto baseline = make(engine.snapshot());
  for (int i = 0; i < steps; ++i) {
    ASSERT_TRUE(engine.step().ok());
    baseline.step();
    SCOPED_TRACE(i);
    expect_same(baseline.outcome(), engine, i == 0 ? 1e-14 : 1e-9);
  }
}

TEST(Baselines, ThePapersMannerStepsTheSameModel) {
  expect_the_same_course(all_pairs, 4);
  expect_the_same_course(by_element, 4);
}

TEST(Baselines, ThePapersMannerWithBoundsStepsTheSameModel) {
  expect_the_same_course(with_bounds, 20);
}

TEST(Baselines, PlainEigenStepsTheSameModel) {
  expect_the_same_course(eigen, 20);
}

/// Float rounds so coarsely that the courses part soon: each step is held against its own start.
TEST(Baselines, SingleStepsAgreeInFloat) {
  Simulation engine = huddle(Precision::float_);
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    PlainEigen<float> baseline = eigen_in_float(engine.snapshot());
    PaperManner exact = with_bounds(engine.snapshot());
    baseline.step();
    exact.step();
    ASSERT_TRUE(engine.step().ok());
    expect_same(baseline.outcome(), engine, 2e-6);
    expect_same(exact.outcome(), engine, 2e-6);
  }
}

TEST(Baselines, RefuseWhatTheyDoNotStep) {
  Params params;
  params.heading = Heading::body;
  EXPECT_THROW(eigen(Simulation(params).snapshot()), std::invalid_argument);
  params = {};
  params.integrator = Integrator::explicit_;
  EXPECT_THROW(all_pairs(Simulation(params).snapshot()), std::invalid_argument);
  params = {};
  params.deformation = 0.95;
  EXPECT_THROW(with_bounds(Simulation(params).snapshot()), std::invalid_argument);
  params = {};
  params.heat = HeatRule::euler;
  EXPECT_THROW(eigen_in_float(Simulation(params).snapshot()), std::invalid_argument);
}

}  // namespace
}  // namespace pupflow::bench
