// The paper's Figure 2 in small, from the command line: 6 temperatures, 4 litters each. The bounds
// are far from what docs/validation.md measures.
#include <gmock/gmock.h>

#include "tests/study/sweep_program.h"

namespace pupflow::study::test {
namespace {

class Figure2InSmall : public SweepProgram, public ::testing::WithParamInterface<std::string> {};

TEST_P(Figure2InSmall, HuddlesInTheColdAndDispersesInTheWarm) {
  expect(0, {"sweep", "--vary", "ta=0.1,0.25,0.4,0.65,0.8,0.95", "--seeds", "4", "--set",
             "heading=" + GetParam(), "--out", "s"});
  const auto rows = rows_of(path("s/summary.csv"));
  ASSERT_EQ(rows.size(), 6u);
  enum Column { ta = 0, runs = 1, tb = 2, huddling = 4, groups = 6, largest = 8, flow = 10 };
  double cold_flow = 0, warm_flow = 0;
  for (const Words& row : rows) {
    const auto value = [&](Column c) { return std::stod(row[c]); };
    EXPECT_EQ(value(runs), 4);
    // Above an isolated pup, T_a + G/k1 = T_a + 0.0611, and below one that is three quarters
    // covered.
    EXPECT_GT(value(tb), value(ta) + 0.061) << "at T_a " << row[ta];
    EXPECT_LT(value(tb), value(ta) + 0.244) << "at T_a " << row[ta];
    const bool cold = value(ta) < 0.5;
    (cold ? cold_flow : warm_flow) += value(flow) / 3;
    if (cold) {
      EXPECT_GT(value(huddling), 0.4) << "at T_a " << row[ta];
      EXPECT_LT(value(groups), 6) << "at T_a " << row[ta];
      EXPECT_GT(value(largest), 5) << "at T_a " << row[ta];
    } else {
      EXPECT_LT(value(huddling), 0.4) << "at T_a " << row[ta];
      EXPECT_GT(value(groups), 2) << "at T_a " << row[ta];
    }
  }
  EXPECT_GT(warm_flow, cold_flow);
}

INSTANTIATE_TEST_SUITE_P(BothHeadings, Figure2InSmall, ::testing::Values("course", "body"));

}  // namespace
}  // namespace pupflow::study::test
