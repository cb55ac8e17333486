#include "app/study/transition.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/study/small_design.h"

namespace pupflow::study {
namespace {

using test::small_design;

/// One run at each point, with these values of some observables.
struct Curve {
  std::vector<double> huddling;
  std::vector<double> flow{}, exposed_sd{}, mean_tb{};

  std::vector<Summary> of(const Design& design) const {
    const auto at = [](const std::vector<double>& values, std::size_t i) {
      return values.empty() ? 0 : values[i];
    };
    std::vector<Row> rows;
    for (std::size_t i = 0; i < huddling.size(); ++i) {
      rows.push_back(test::row_of(static_cast<std::int64_t>(i), 0));
      rows.back().means.huddling = huddling[i];
      rows.back().means.flow = at(flow, i);
      rows.back().means.mean_tb = at(mean_tb, i);
      rows.back().exposed_sd = at(exposed_sd, i);
    }
    return summarise(design, rows);
  }
};

TEST(TransitionFinder, FindsSteepestFallPeaksAndTheRangeHeld) {
  const Design design = small_design({"ta=0,0.4,0.5,0.6,0.8,1"}, 1);
  const auto found = find_transition(design, Curve{{0.30, 0.28, 0.20, 0.15, 0.06, 0.05},
                                                   {1, 4, 2, 2, 5, 1},
                                                   {0.1, 0.2, 0.3, 0.2, 0.1, 0.1},
                                                   {0.2, 0.56, 0.58, 0.62, 0.86, 1.08}}
                                                 .of(design));
  ASSERT_TRUE(found);
  // -0.08 in 0.1, although 0.09 are lost later, in 0.2
  EXPECT_EQ(found->steepest, (Range{0.4, 0.5}));
  EXPECT_EQ(found->flow.ta, 0.8);
  EXPECT_EQ(found->flow.value, 5);
  EXPECT_EQ(found->exposed_sd.ta, 0.5);
  EXPECT_EQ(found->exposed_sd.value, 0.3);
  EXPECT_EQ(transition_text(design, *found),
            "1 - A falls most steeply between T_a 0.400 and 0.500; T_p - G/k1 = 0.539\n"
            "the standard deviation of A is highest, 0.3, at T_a 0.500\n"
            "pup flow (lag 1) is highest, 5 /s, at T_a 0.800\n"
            "mean T_b is within 0.03 of T_p over T_a 0.450 to 0.608\n");
  EXPECT_EQ(
      transition_text(design, *found, true),
      "1 - A falls most steeply between T_a 0.400 (24.7 °C) and 0.500 (30.8 °C); T_p - G/k1 = "
      "0.539 (33.2 °C)\n"
      "the standard deviation of A is highest, 0.3, at T_a 0.500 (30.8 °C)\n"
      "pup flow (lag 1) is highest, 5 /s, at T_a 0.800 (49.3 °C)\n"
      "mean T_b is within 0.03 of T_p over T_a 0.450 (27.7 °C) to 0.608 (37.5 °C)\n");
}

TEST(TransitionFinder, FindsTheSameInAnyOrderOfTheValues) {
  const auto text = [](const std::string& ta, const Curve& curve) {
    const Design design = small_design({ta}, 1);
    return transition_text(design, *find_transition(design, curve.of(design)));
  };
  const std::string expected =
      text("ta=0.4,0.5,0.6", {{0.3, 0.2, 0.15}, {1, 2, 3}, {3, 2, 1}, {0.5, 0.6, 0.7}});
  EXPECT_EQ(expected.find("1 - A falls most steeply between T_a 0.400 and 0.500"), 0u);
  EXPECT_EQ(text("ta=0.4,0.6,0.5", {{0.3, 0.15, 0.2}, {1, 3, 2}, {3, 1, 2}, {0.5, 0.7, 0.6}}),
            expected);
  EXPECT_EQ(text("ta=0.6,0.5,0.4", {{0.15, 0.2, 0.3}, {3, 2, 1}, {1, 2, 3}, {0.7, 0.6, 0.5}}),
            expected);
}

TEST(TransitionFinder, ClaimsNothingThatIsNotSo) {
  Design design = small_design({"ta=0,0.5"}, 1);
  design.base.air_conductance = 0;
  design.base.flow_lag = 10;
  const auto found = find_transition(design, Curve{{0.1, 0.1}, {1, 2}}.of(design));
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->steepest);
  EXPECT_EQ(transition_text(design, *found),
            "1 - A does not fall\n"
            "the standard deviation of A is highest, 0, at T_a 0.000\n"
            "pup flow (lag 10) is highest, 2 /s, at T_a 0.500\n"
            "mean T_b is within 0.03 of T_p at no T_a of this sweep\n");
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();  // as over a single step
  const Curve brief{{0.1, 0.1}, {kNone, kNone}, {kNone, kNone}};
  EXPECT_EQ(transition_text(design, *find_transition(design, brief.of(design))),
            "1 - A does not fall\n"
            "mean T_b is within 0.03 of T_p at no T_a of this sweep\n");
}

std::vector<Range> held(const std::string& ta, const std::vector<double>& tb) {
  const Design design = small_design({ta}, 1);
  return held_ranges(design, Curve{tb, {}, {}, tb}.of(design), 0);
}

TEST(HeldRanges, GoStraightFromPointToPoint) {
  // T_p is 0.6, so 0.57 to 0.63 count.
  const auto crossing = held("ta=0,1", {0.5, 0.7});
  ASSERT_EQ(crossing.size(), 1u);
  EXPECT_NEAR(crossing[0].from, 0.35, 1e-12);
  EXPECT_NEAR(crossing[0].to, 0.65, 1e-12);
  EXPECT_EQ(held("ta=0,0.5,1", {0.58, 0.6, 0.62}), (std::vector<Range>{{0, 1}}));
  EXPECT_EQ(held("ta=1,0,0.5", {0.62, 0.58, 0.6}), (std::vector<Range>{{0, 1}}));
  EXPECT_EQ(held("ta=0,1", {0.6, 0.6}), (std::vector<Range>{{0, 1}}));
  EXPECT_TRUE(held("ta=0,1", {0.5, 0.5}).empty());
  EXPECT_TRUE(held("ta=0,1", {0.2, 0.5}).empty());
}

TEST(HeldRanges, AreSeveralWhereTheyDoNotHangTogether) {
  const auto two = held("ta=0,1,2,3", {0.6, 0.5, 0.5, 0.7});
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].from, 0);
  EXPECT_NEAR(two[0].to, 0.3, 1e-12);
  EXPECT_NEAR(two[1].from, 2.35, 1e-12);
  EXPECT_NEAR(two[1].to, 2.65, 1e-12);
}

TEST(HeldRanges, AreInterruptedByAPointThatFailed) {
  const Design design = small_design({"ta=0,1,2"}, 1);
  std::vector<Row> rows{test::row_of(0, 0.6), test::bad_row(1), test::row_of(2, 0.6)};
  EXPECT_TRUE(held_ranges(design, summarise(design, rows), 0).empty());
}

TEST(TransitionFinder, KeepsSilentWhereThereIsNoCurve) {
  const auto none = [](const Design& design, std::size_t points) {
    const std::vector<double> values(points, 1.0);
    return !find_transition(design, Curve{values}.of(design));
  };
  EXPECT_TRUE(none(small_design({"beta=0,0.5"}, 1), 2));
  EXPECT_TRUE(none(small_design({"ta=0,1", "beta=0,0.5"}, 1), 4));
  EXPECT_TRUE(none(small_design({"ta=0.5"}, 1), 1));
  EXPECT_FALSE(none(small_design({"ta=0,1"}, 1), 2));
  EXPECT_FALSE(none(small_design({"ta=1,0"}, 1), 2));
  const Design design = small_design({"ta=0,1"}, 1);
  EXPECT_FALSE(find_transition(design, summarise(design, {test::row_of(0, 1), test::bad_row(1)})));
}

}  // namespace
}  // namespace pupflow::study
