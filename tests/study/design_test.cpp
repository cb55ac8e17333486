#include "app/study/design.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/app/failing.h"
#include "tests/study/small_design.h"

namespace pupflow::study {
namespace {

using io::ExitCode;
using pupflow::test::failure_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Axis, SpacesValuesEvenlyWithBothEnds) {
  const Axis axis = parse_axis("ta=0:1:5");
  EXPECT_EQ(axis.parameter->name, "ta");
  EXPECT_THAT(axis.values, ElementsAre(0, 0.25, 0.5, 0.75, 1));
  EXPECT_THAT(parse_axis("ta=1:0:3").values, ElementsAre(1, 0.5, 0));
  EXPECT_THAT(parse_axis("pups=2:10:3").values, ElementsAre(2, 6, 10));
  EXPECT_EQ(parse_axis("ta=0:0.3:4").values.back(), 0.3);
}

TEST(Axis, HasNoRoundingNoise) {
  EXPECT_THAT(parse_axis("ta=0.2:0.8:4").values, ElementsAre(0.2, 0.4, 0.6, 0.8));
  EXPECT_THAT(parse_axis("ta=0.8:0.2:4").values, ElementsAre(0.8, 0.6, 0.4, 0.2));
  EXPECT_THAT(parse_axis("ta=-0.3:.3:3").values, ElementsAre(-0.3, 0, 0.3));
  EXPECT_THAT(parse_axis("ta=1e-3:+7E-3:4").values, ElementsAre(0.001, 0.003, 0.005, 0.007));
  const Axis tenths = parse_axis("ta=0:1:11");
  for (int i = 0; i <= 10; ++i) EXPECT_EQ(tenths.values[static_cast<std::size_t>(i)], i / 10.0);
}

TEST(Axis, OfFigure2HasTheValuesThatItAlwaysHad) {
  const Axis axis = parse_axis("ta=0:1:24");
  for (int i = 0; i < 24; ++i) EXPECT_EQ(axis.values[static_cast<std::size_t>(i)], i / 23.0);
}

TEST(Axis, SpacesNumbersOfManyDigitsToo) {
  EXPECT_THAT(parse_axis("ta=0:1e300:3").values, ElementsAre(0, 5e299, 1e300));
  const Axis axis = parse_axis("ta=0.123456789012345678:0.3:3");
  EXPECT_EQ(axis.values[0], 0.123456789012345678);
  EXPECT_NEAR(axis.values[1], 0.211728394506172839, 1e-15);
  EXPECT_EQ(axis.values[2], 0.3);
}

TEST(Axis, TakesStepsUpToTheEndThatTheyReach) {
  EXPECT_THAT(parse_axis("ta=0:0.3:step=0.1").values, ElementsAre(0, 0.1, 0.2, 0.3));
  EXPECT_THAT(parse_axis("ta=0.3:0:step=0.1").values, ElementsAre(0.3, 0.2, 0.1, 0));
  EXPECT_THAT(parse_axis("ta=0:1:step=0.3").values, ElementsAre(0, 0.3, 0.6, 0.9));
  EXPECT_THAT(parse_axis("ta=0:1:step=0.33333333333333").values.back(), 1);
  EXPECT_THAT(parse_axis("ta=0:1:step=2").values, ElementsAre(0));
  EXPECT_THAT(parse_axis("pups=2:9:step=3").values, ElementsAre(2, 5, 8));
  const Axis axis = parse_axis("ta=0:1:step=0.05");
  ASSERT_EQ(axis.values.size(), 21u);
  for (int i = 0; i <= 20; ++i) EXPECT_EQ(axis.values[static_cast<std::size_t>(i)], i / 20.0);
}

TEST(Axis, TakesListsInTheirOrder) {
  EXPECT_THAT(parse_axis("beta=0.5,0,0.9").values, ElementsAre(0.5, 0, 0.9));
  EXPECT_THAT(parse_axis("heading=course,body").values, ElementsAre(0, 1));
  EXPECT_THAT(parse_axis("ta=0.3").values, ElementsAre(0.3));
}

struct Wrong {
  const char* text;
  const char* said;
};

class WrongAxis : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongAxis, IsRefusedWithWhatWouldBeRight) {
  const std::string message = failure_of(ExitCode::bad_input, [] { parse_axis(GetParam().text); });
  EXPECT_THAT(message, HasSubstr("--vary"));
  EXPECT_THAT(message, HasSubstr(GetParam().said));
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongAxis,
    ::testing::Values(
        Wrong{"", "name=from:to:count"}, Wrong{"ta", "name=from:to:count"},
        Wrong{"ta=0:1", "name=from:to:count"}, Wrong{"ta=0:1:2:3", "name=a,b,c"},
        Wrong{"ta=", "ta"}, Wrong{"ta=0,", "ta"}, Wrong{"ta=0,x", "'x'"},
        Wrong{"tb=0:1:3", "did you mean 'tb0'"}, Wrong{"zzzzzz=1", "pupflow params"},
        Wrong{"seed=1,2", "--seeds"}, Wrong{"ta=0:1:1", "whole number from 2"},
        Wrong{"ta=0:1:2.5", "whole number from 2"}, Wrong{"ta=0:1:-3", "whole number from 2"},
        Wrong{"ta=0:1:99999999999999999999", "whole number from 2"}, Wrong{"ta=1:1:3", "no range"},
        Wrong{"ta=0:1:step=", "a number above 0"}, Wrong{"ta=0:1:step=0", "a number above 0"},
        Wrong{"ta=0:1:step=-1", "a number above 0"}, Wrong{"ta=0:1:step=x", "'x'"},
        Wrong{"ta=0:1:step=1e-9", "take a larger step"}, Wrong{"ta=1:1:step=1", "no range"},
        Wrong{"pups=2:9:step=1.5", "not all allowed"}, Wrong{"ta=0,1,0", "listed twice"},
        Wrong{"pups=2:5:3", "not all allowed"}, Wrong{"alpha=0:2:3", "alpha"},
        Wrong{"heading=0:1:2", "heading=course,body"}, Wrong{"heading=north", "course or body"}));

TEST(ShardText, IsIOfN) {
  EXPECT_EQ(parse_shard("1/1"), (Shard{1, 1}));
  EXPECT_EQ(parse_shard("3/17"), (Shard{3, 17}));
  EXPECT_TRUE(parse_shard("1/1").whole());
  EXPECT_FALSE(parse_shard("1/2").whole());
}

class WrongShard : public ::testing::TestWithParam<const char*> {};

TEST_P(WrongShard, IsRefusedWithAnExample) {
  EXPECT_THAT(failure_of(ExitCode::bad_input, [] { parse_shard(GetParam()); }),
              HasSubstr("i from 1 to n, e.g. 1/4"));
}

INSTANTIATE_TEST_SUITE_P(All, WrongShard,
                         ::testing::Values("", "/", "1", "1/", "/2", "0/2", "3/2", "-1/2", "1/2/3",
                                           "1.5/2", "a/b", "1/2 ", "1/99999999999999999999",
                                           "1/2000000"));

TEST(ADesign, TurnsTheLastAxisFastest) {
  const Design design = test::small_design({"ta=0.1,0.2", "beta=0,0.5,0.7"}, 4);
  EXPECT_EQ(design.points(), 6);
  EXPECT_EQ(design.runs(), 24);
  EXPECT_THAT(design.values_at(0), ElementsAre(0.1, 0));
  EXPECT_THAT(design.values_at(1), ElementsAre(0.1, 0.5));
  EXPECT_THAT(design.values_at(3), ElementsAre(0.2, 0));
  const Params params = design.params_of(4 * 4 + 3);  // point 4, fourth seed
  EXPECT_EQ(params.ambient_temperature, 0.2);
  EXPECT_EQ(params.deformation, 0.5);
  EXPECT_EQ(params.pups, 3);
  EXPECT_EQ(params.seed, run_seed(1, 43));  // the fourth of ten at point 4
}

TEST(ADesign, KeepsTheNumbersOfItsRunsWhenSeedsAreAdded) {
  for (const std::int64_t more : {1, 2, 9, 10, 11, 25}) {
    const Design few = test::small_design({"ta=0:1:7"}, 1),
                 many = test::small_design({"ta=0:1:7"}, more);
    std::set<std::int64_t> numbers;
    for (std::int64_t run = 0; run < many.runs(); ++run) {
      numbers.insert(many.number_of(run));
      EXPECT_EQ(many.run_of(many.number_of(run)), run);
      EXPECT_EQ(few.run_of(many.number_of(run)),
                run % more == 0 ? std::optional(run / more) : std::nullopt);
    }
    EXPECT_EQ(std::ssize(numbers), many.runs());
    for (std::int64_t point = 0; point < 7; ++point)
      EXPECT_EQ(many.seed_of(point * more), few.seed_of(point));
  }
  EXPECT_FALSE(test::small_design({"ta=0,1"}, 3).run_of(-1));
}

TEST(ADesign, NumbersTenSeedsAndSinglePointsInOrder) {
  // So Figure 2 has the seeds that it always had.
  const Design ten = test::small_design({"ta=0:1:24"}, 10),
               one = test::small_design({"ta=0.5"}, 33);
  for (std::int64_t run = 0; run < ten.runs(); ++run) EXPECT_EQ(ten.seed_of(run), run_seed(1, run));
  for (std::int64_t run = 0; run < one.runs(); ++run) EXPECT_EQ(one.seed_of(run), run_seed(1, run));
}

TEST(ADesign, DealsItsRunsToShards) {
  Design design = test::small_design({"ta=0:1:7"}, 1);
  EXPECT_THAT(design.own_runs(), ElementsAre(0, 1, 2, 3, 4, 5, 6));
  design.shard = {2, 3};
  EXPECT_THAT(design.own_runs(), ElementsAre(1, 4));
  design.shard = {9, 9};
  EXPECT_THAT(design.own_runs(), ElementsAre());
}

TEST(RunSeed, IsOneNumberForEachRunOfASweep) {
  const Parameter* parameter = find_parameter("seed");
  for (std::int64_t base = 0; base < 50; ++base) {
    std::set<std::int64_t> seeds;
    for (std::int64_t run = 0; run < 2000; ++run) {
      const std::int64_t seed = run_seed(base, run);
      EXPECT_EQ(seed, run_seed(base, run));
      seeds.insert(seed);
    }
    EXPECT_EQ(seeds.size(), 2000u);
    Problem problem;
    EXPECT_TRUE(check_value(*parameter, static_cast<double>(*seeds.begin()), problem));
    EXPECT_LT(*seeds.rbegin(), std::int64_t{1} << 31);
  }
  EXPECT_NE(run_seed(1, 0), run_seed(2, 0));
  // Fixed for ever: a row's seed must not change with the version.
  EXPECT_EQ(run_seed(1, 0), 151149761);
  EXPECT_EQ(run_seed(1, 1000), 1140264649);
}

class WrongDesign : public ::testing::Test {
 protected:
  static std::string said(const Design& design) {
    return failure_of(ExitCode::bad_input, [&] { check_design(design); });
  }
};

TEST_F(WrongDesign, VariesAParameterTwice) {
  EXPECT_THAT(said(test::small_design({"ta=0,1", "ta=0.5"}, 1)),
              HasSubstr("--vary ta is given twice"));
}

TEST_F(WrongDesign, HasTooManyRuns) {
  const std::vector<std::string> vary{"ta=0:1:1000", "tp=0:1:1000", "k1=0:1:1000",   "k2=0:1:1000",
                                      "g=0:1:1000",  "v=0:1:1000",  "sigma=0:1:1000"};
  EXPECT_THAT(said(test::small_design(vary, 10)), HasSubstr("vary less or use fewer seeds"));
  Design design = test::small_design({"ta=0,1"}, std::int64_t{1} << 62);
  EXPECT_THAT(said(design), HasSubstr("vary less or use fewer seeds"));
}

TEST_F(WrongDesign, LeavesNoStepForTheMeans) {
  Design design = test::small_design({"steps=20,60"}, 1);
  EXPECT_THAT(said(design), HasSubstr("must exceed discard = 20"));
}

TEST_F(WrongDesign, RecordsMoreThanADiskShouldHold) {
  Design design = test::small_design({"ta=0:1:1001"}, 100);
  design.record_every = 1;
  EXPECT_THAT(said(design), HasSubstr("--record: 100100 runs"));
  design = test::small_design({"steps=100,2000000"}, 1);
  design.record_every = 1;
  EXPECT_THAT(said(design), HasSubstr("give a larger --every"));
  design.record_every = 2;
  check_design(design);
}

TEST_F(WrongDesign, HasAnUnsoundPointSomewhere) {
  Design design = test::small_design({"pup_radius=0.2,1.99"}, 1);
  EXPECT_THAT(said(design), HasSubstr("arena_radius"));
}

}  // namespace
}  // namespace pupflow::study
