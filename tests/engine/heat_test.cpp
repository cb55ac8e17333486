#include "engine/heat.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pupflow {
namespace {

TEST(HeatStep, ExactRuleSolvesTheLinearEquation) {
  Params p;
  p.dt = 0.3;
  for (const double exposed : {0.0, 0.25, 1.0}) {
    const double k = p.k1 * exposed + p.k2 * (1 - exposed);
    const double settled = (p.g + p.k1 * exposed * p.ta + p.k2 * (1 - exposed) * 0.7) / k;
    const double expected = settled + (0.5 - settled) * std::exp(-k * p.dt);
    EXPECT_NEAR(heat_step(p, 0.5, exposed, 0.7), expected, 1e-15);
  }
}

TEST(HeatStep, EulerRuleIsOneEulerStep) {
  Params p;
  p.heat = HeatRule::euler;
  const double rate = p.g - p.k1 * 0.75 * (0.5 - p.ta) - p.k2 * 0.25 * (0.5 - 0.7);
  EXPECT_DOUBLE_EQ(heat_step(p, 0.5, 0.75, 0.7), 0.5 + p.dt * rate);
}

TEST(HeatStep, RulesAgreeToFirstOrder) {
  Params exact, euler;
  euler.heat = HeatRule::euler;
  const auto error = [&](double dt) {
    exact.dt = euler.dt = dt;
    return std::abs(heat_step(exact, 0.9, 0.5, 0.3) - heat_step(euler, 0.9, 0.5, 0.3));
  };
  EXPECT_NEAR(error(0.01) / error(0.005), 4, 0.05);  // local error h^2: a first-order method
}

TEST(HeatStep, WithoutConductanceOnlyThermogenesisIsLeft) {
  Params p;
  p.k1 = p.k2 = 0;
  EXPECT_DOUBLE_EQ(heat_step(p, 0.5, 1, 0), 0.5 + p.dt * p.g);
}

TEST(HeatStep, StiffConductanceGoesStraightToEquilibrium) {
  Params p;
  p.k1 = 1e8;
  EXPECT_NEAR(heat_step(p, 100, 1, 0), p.ta + p.g / p.k1, 1e-12);
}

TEST(HeatStep, ExchangeIsAbsentWithoutContact) {
  Params p;
  EXPECT_EQ(heat_step(p, 0.5, 1, 0.0), heat_step(p, 0.5, 1, 1e9));
}

}  // namespace
}  // namespace pupflow
