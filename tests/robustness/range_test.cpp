// Every parameter at both ends of its range: 100 steps end in a finite state or a named status,
// never in a crash, a hang or a silent NaN.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pupflow/observer.h"
#include "pupflow/simulation.h"
#include "tests/support/litter.h"

namespace pupflow {
namespace {

bool all_finite(const Simulation& s) {
  for (const auto& x : testing::all_positions(s)) {
    if (!x.allFinite()) return false;
  }
  for (const auto& v : testing::all_velocities(s)) {
    if (!v.allFinite()) return false;
  }
  for (int pup = 0; pup < s.pups(); ++pup) {
    if (!std::isfinite(s.view().tb[pup]) || !std::isfinite(s.view().heading[pup])) return false;
  }
  return true;
}

std::vector<double> ends(const Parameter& row) {
  const double low = std::isfinite(row.min) ? row.min : -1e300;
  const double high = std::isfinite(row.max) ? row.max : 1e300;
  return {
      row.min_open ? std::max(std::nextafter(low, high), std::numeric_limits<double>::min()) : low,
      high};
}

class RangeEnds : public ::testing::TestWithParam<std::tuple<std::size_t, Precision>> {};

TEST_P(RangeEnds, StepToAFiniteStateOrANamedStatus) {
  const Parameter& row = parameters()[std::get<0>(GetParam())];
  for (const double end : ends(row)) {
    Params p;
    p.precision = std::get<1>(GetParam());
    row.set(p, end);
    if (row.name == "pup_radius" || row.name == "point_radius") p.arena_radius = 4e6;
    if (row.name == "arena_radius") p.arena_radius = std::max(end, 0.3 + 1e-12);
    if (row.name == "arena_radius") p.start_spread = std::min(p.start_spread, 0.7 * p.arena_radius);
    if (row.name == "start_spread") p.arena_radius = std::max(p.arena_radius, 1.5 * end);
    if (row.name == "dt" && p.precision == Precision::float_) p.dt = std::max(p.dt, 1e-4);
    ASSERT_TRUE(check(p).empty()) << row.name << " = " << end << ": " << check(p)[0].message;
    const int steps = p.pups > 1000 ? 20 : 100;
    Simulation s(p);
    Observer observer(s);
    Status status;
    for (int i = 0; i < steps && status.ok(); ++i) {
      status = s.step();
      if (status.ok()) observer.observe(s);
    }
    if (status.ok()) {
      EXPECT_TRUE(all_finite(s)) << row.name << " = " << end;
    } else {
      EXPECT_GE(status.step, 1);
      EXPECT_GE(status.pup, 0);
      EXPECT_NE(status.message().find(std::string(stage_name(status.stage))), std::string::npos);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, RangeEnds,
                         ::testing::Combine(::testing::Range(std::size_t{0}, parameters().size()),
                                            ::testing::Values(Precision::float_,
                                                              Precision::double_)),
                         [](const auto& test) {
                           return std::string(parameters()[std::get<0>(test.param)].name) +
                                  (std::get<1>(test.param) == Precision::float_ ? "_float"
                                                                                : "_double");
                         });

TEST(Range, AmbientTemperaturesFarOutWork) {
  for (const double ta : {-1e6, -1.0, 2.0, 1e6}) {
    Params p;
    p.ambient_temperature = ta;
    Simulation s(p);
    EXPECT_TRUE(s.run(600).ok()) << ta;
    EXPECT_TRUE(all_finite(s));
  }
}

TEST(Range, SinglePrecisionRefusesTinySteps) {
  Params p;
  p.dt = 0.99e-4;
  EXPECT_TRUE(check(p).empty());
  p.precision = Precision::float_;
  const std::vector<Problem> problems = check(p);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].parameter, "dt");
  EXPECT_THROW(Simulation{p}, InvalidParams);
  p.dt = 1e-4;
  EXPECT_TRUE(check(p).empty());
}

TEST(Range, AlphaAndBetaAtTheirEndsInAllCombinations) {
  for (const double alpha : {0.0, 1.0}) {
    for (const double beta : {0.0, 1.0}) {
      Params p;
      p.rigidity = alpha;
      p.deformation = beta;
      Simulation s(p);
      const Status status = s.run(600);
      EXPECT_TRUE(!status.ok() || all_finite(s)) << alpha << ' ' << beta;
    }
  }
}

}  // namespace
}  // namespace pupflow
