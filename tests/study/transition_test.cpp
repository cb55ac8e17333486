#include "app/study/transition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/study/small_design.h"

namespace pupflow::study {
namespace {

using test::small_design;
using ::testing::HasSubstr;
using ::testing::Not;

/// One run at each point, with these huddling and flow values.
std::vector<Summary> curve(const Design& design, const std::vector<double>& huddling,
                           const std::vector<double>& flow) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < huddling.size(); ++i) {
    rows.push_back(test::row_of(static_cast<std::int64_t>(i), 0));
    rows.back().means.huddling = huddling[i];
    rows.back().means.flow = flow[i];
  }
  return summarise(design, rows);
}

TEST(TransitionFinder, FindsSteepestFallPeakAndWarmLevel) {
  const Design design = small_design({"ta=0,0.4,0.5,0.6,0.8,1"}, 1);
  const auto found = find_transition(
      design, curve(design, {0.30, 0.28, 0.20, 0.15, 0.06, 0.05}, {1, 4, 5, 2, 3, 1}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->steepest_from, 0.4);  // -0.08 in 0.1, although 0.09 are lost later, in 0.2
  EXPECT_EQ(found->steepest_to, 0.5);
  EXPECT_EQ(found->flow_peak_ta, 0.5);
  EXPECT_EQ(found->flow_peak, 5);
  ASSERT_TRUE(found->warm_flow);
  EXPECT_DOUBLE_EQ(*found->warm_flow, 2);
  const std::string text = transition_text(design, *found);
  EXPECT_THAT(text, HasSubstr("between T_a 0.4 and 0.5; T_p - G/k1 = 0.5389"));
  EXPECT_THAT(text, HasSubstr("at T_a 0.5: 2.5 times"));
}

TEST(TransitionFinder, SaysNothingOfWhatTheSweepDoesNotCover) {
  Design design = small_design({"ta=0,0.5"}, 1);
  design.base.k1 = 0;
  const auto found = find_transition(design, curve(design, {0.3, 0.1}, {1, 2}));
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->warm_flow);
  const std::string text = transition_text(design, *found);
  EXPECT_THAT(text, Not(HasSubstr("times")));
  EXPECT_THAT(text, Not(HasSubstr("inf")));
}

TEST(TransitionFinder, KeepsSilentWhereThereIsNoCurve) {
  const auto none = [](const Design& design, std::size_t points) {
    const std::vector<double> values(points, 1.0);
    return !find_transition(design, curve(design, values, values));
  };
  EXPECT_TRUE(none(small_design({"beta=0,0.5"}, 1), 2));
  EXPECT_TRUE(none(small_design({"ta=0,1", "beta=0,0.5"}, 1), 4));
  EXPECT_TRUE(none(small_design({"ta=0.5"}, 1), 1));
  EXPECT_TRUE(none(small_design({"ta=1,0"}, 1), 2));
  EXPECT_FALSE(none(small_design({"ta=0,1"}, 1), 2));
  const Design design = small_design({"ta=0,1"}, 1);
  EXPECT_FALSE(find_transition(design, summarise(design, {test::row_of(0, 1), test::bad_row(1)})));
}

}  // namespace
}  // namespace pupflow::study
