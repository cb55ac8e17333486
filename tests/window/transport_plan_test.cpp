#include "app/window/panels/transport_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace pupflow::window {
namespace {

constexpr TransportPart kLast = TransportPart::compare;

std::vector<TransportPart> all_parts() {
  std::vector<TransportPart> parts;
  for (int i = 0; i <= static_cast<int>(kLast); ++i) parts.push_back(static_cast<TransportPart>(i));
  return parts;
}

float row_width(const TransportPlan& plan, int row) {
  float width = -kTransportGap;
  for (const TransportPart part : all_parts()) {
    if (plan.row_of(part) == row) width += kTransportGap + transport_width(part);
  }
  return width;
}

TEST(TransportPlan, AUsualWindowHasTwoRows) {
  const TransportPlan plan = plan_transport(45);
  EXPECT_EQ(plan.rows, 2);
  EXPECT_EQ(plan.row_of(TransportPart::play), 0);
  EXPECT_EQ(plan.row_of(TransportPart::speed), 1);
  EXPECT_EQ(plan.row_of(TransportPart::compare), 1);
}

TEST(TransportPlan, NoRowIsWiderThanTheWindow) {
  for (float width = 16; width < 120; width += 0.5f) {
    const TransportPlan plan = plan_transport(width);
    for (int row = 0; row < plan.rows; ++row) {
      EXPECT_GT(row_width(plan, row), 0) << width << ": no row is empty";
      EXPECT_LE(row_width(plan, row), width) << width;
    }
  }
}

TEST(TransportPlan, WhatANarrowWindowLeavesOutIsInItsMenu) {
  const TransportPlan plan = plan_transport(20);
  EXPECT_TRUE(plan.compact);
  EXPECT_GE(plan.row_of(TransportPart::more), 0);
  EXPECT_LT(plan.row_of(TransportPart::speed), 0);
  EXPECT_LT(plan_transport(45).row_of(TransportPart::more), 0);
}

TEST(TransportPlan, ThePlayButtonsComeFirstInANarrowWindow) {
  for (const TransportPart part : {TransportPart::play, TransportPart::step_back,
                                   TransportPart::step, TransportPart::restart}) {
    EXPECT_EQ(plan_transport(20).row_of(part), 0);
  }
}

TEST(TransportPlan, EachRowHasOnePartThatEndsIt) {
  for (const float width : {18.0f, 30.0f, 45.0f, 90.0f}) {
    const TransportPlan plan = plan_transport(width);
    const auto parts = all_parts();
    const auto ends = std::count_if(parts.begin(), parts.end(), [&](TransportPart part) {
      return plan.row_of(part) >= 0 && plan.ends_row(part);
    });
    EXPECT_EQ(ends, plan.rows) << width;
  }
}

}  // namespace
}  // namespace pupflow::window
