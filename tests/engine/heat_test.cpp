#include "engine/heat.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pupflow {
namespace {

TEST(HeatStep, ExactRuleSolvesTheLinearEquation) {
  Params p;
  p.dt = 0.3;
  for (const double exposed : {0.0, 0.25, 1.0}) {
    const double k = p.air_conductance * exposed + p.contact_conductance * (1 - exposed);
    const double settled = (p.thermogenesis + p.air_conductance * exposed * p.ambient_temperature +
                            p.contact_conductance * (1 - exposed) * 0.7) /
                           k;
    const double expected = settled + (0.5 - settled) * std::exp(-k * p.dt);
    EXPECT_NEAR(heat_step(p, 0.5, exposed, 0.7), expected, 1e-15);
  }
}

TEST(HeatStep, EulerRuleIsOneEulerStep) {
  Params p;
  p.heat = HeatRule::euler;
  const double rate = p.thermogenesis - p.air_conductance * 0.75 * (0.5 - p.ambient_temperature) -
                      p.contact_conductance * 0.25 * (0.5 - 0.7);
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
  p.air_conductance = p.contact_conductance = 0;
  EXPECT_DOUBLE_EQ(heat_step(p, 0.5, 1, 0), 0.5 + p.dt * p.thermogenesis);
}

TEST(HeatStep, StiffConductanceGoesStraightToEquilibrium) {
  Params p;
  p.air_conductance = 1e8;
  EXPECT_NEAR(heat_step(p, 100, 1, 0), p.ambient_temperature + p.thermogenesis / p.air_conductance,
              1e-12);
}

// Where rates overflow. Right answers by hand: with k dt huge the step ends at equilibrium.
TEST(HeatStep, OverflowingConductanceGoesToEquilibrium) {
  Params p;
  p.ambient_temperature = 0.25;
  for (const double k1 : {1e100, 1e160, 1e305, 1.7e308}) {
    for (const double tb : {-1.7e308, -1e160, 0.6, 1e100, 1e160, 1.7e308}) {
      p.air_conductance = k1;
      EXPECT_EQ(heat_step(p, tb, 1, 0), 0.25) << k1 << ' ' << tb;
      EXPECT_EQ(heat_step(p, tb, 0.5, 0.75), 0.25) << k1 << ' ' << tb;  // k2 = 1 is nothing here
    }
  }
  p.air_conductance = p.contact_conductance = 1e160;
  EXPECT_EQ(heat_step(p, 1e300, 0.5, 0.75), 0.5);     // halfway between 0.25 and 0.75
  EXPECT_EQ(heat_step(p, 1e300, 0.75, 0.75), 0.375);  // a quarter of the way
  EXPECT_EQ(heat_step(p, 0.6, 0.5, 1e300), 0.5e300);  // a neighbour as hot as that
  EXPECT_EQ(heat_step(p, 0.6, 0.5, -1e308), -0.5e308);
  p.thermogenesis = 1e160;
  EXPECT_DOUBLE_EQ(heat_step(p, 1e300, 1, 0), 1.25);  // T_a + G/k1
  p.dt = 1e200;                                       // k dt overflows, too
  EXPECT_DOUBLE_EQ(heat_step(p, 1e300, 1, 0), 1.25);
}

TEST(HeatStep, OverflowingDifferencesOfTemperatureDoNotCount) {
  Params p;
  p.contact_conductance = p.thermogenesis = 0;
  p.air_conductance = 1;
  p.dt = 0.01;
  p.ambient_temperature = -1.5e308;
  // T_a + (T_b - T_a) e^(-0.01), the difference being 3e308.
  EXPECT_NEAR(heat_step(p, 1.5e308, 1, 0) / 1e308, -1.5 + 3 * std::exp(-0.01), 1e-15);
  p.heat = HeatRule::euler;
  EXPECT_NEAR(heat_step(p, 1.5e308, 1, 0) / 1e308, 1.5 - 3 * 0.01, 1e-15);
  p.air_conductance = 1e3;  // T_b - T_a = 1e306, times k1 is too much, times dt is 1e307
  p.ambient_temperature = 0;
  EXPECT_NEAR(heat_step(p, 1e306, 1, 0) / 1e306, 1 - 10, 1e-14);
  p.air_conductance = 1e160;
  EXPECT_FALSE(std::isfinite(heat_step(p, 1e160, 1, 0)));  // Euler's step itself leaves the range
}

TEST(HeatStep, FormsForSmallAndLargeDecayMeet) {
  Params p;
  p.air_conductance = 1;
  p.thermogenesis = 0.055;
  const auto after = [&](double dt) {
    p.dt = dt;
    return heat_step(p, 0.9, 0.75, 0.3);
  };
  EXPECT_NEAR(after(1), after(std::nextafter(1, 2)), 1e-15);
}

// The mean over what a pup touches, where the sum overflows.
TEST(Heat, TouchedTemperaturesMayAddUpToMoreThanADoubleHolds) {
  State<double> state = make_state<double>(2, 294);
  state.tb = {0.6, 1.5e308};
  state.exposed[0] = 0.5;
  for (int i = 0; i < 147; ++i) {
    state.touched[i] = 1;
    state.touching_points[i / 64] |= std::uint64_t{1} << (i % 64);
  }
  Params p;
  p.air_conductance = 0;
  p.contact_conductance = 1e160;
  double next = 0;
  EXPECT_TRUE(heat(p, true, state, 0, next).ok());
  EXPECT_NEAR(next / 1.5e308, 1, 1e-14);  // sums of 147 round
}

TEST(HeatStep, ExchangeIsAbsentWithoutContact) {
  Params p;
  EXPECT_EQ(heat_step(p, 0.5, 1, 0.0), heat_step(p, 0.5, 1, 1e9));
}

}  // namespace
}  // namespace pupflow
