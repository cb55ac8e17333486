#include "app/study/latin.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/app/failing.h"
#include "tests/study/small_design.h"

namespace pupflow::study {
namespace {

using ::testing::HasSubstr;

Design latin(const std::vector<std::string>& vary, std::int64_t points, std::int64_t seed = 1) {
  Design design = test::small_design({}, 2);
  design.base.seed = seed;
  std::vector<Span> spans;
  for (const std::string& span : vary) spans.push_back(parse_span(span));
  spread_latin(design, spans, points);
  return design;
}

TEST(LatinHypercube, HasOnePointInEachPartOfEachRange) {
  const Design design = latin({"ta=0.2:0.6", "beta=0.9:0"}, 40);
  EXPECT_EQ(design.points(), 40);
  EXPECT_EQ(design.runs(), 80);
  for (std::size_t a = 0; a < 2; ++a) {
    std::vector<double> values = design.axes[a].values;
    std::sort(values.begin(), values.end());
    const double low = a == 0 ? 0.2 : 0, width = a == 0 ? 0.4 : 0.9;
    for (int i = 0; i < 40; ++i) {
      EXPECT_EQ(std::floor((values[static_cast<std::size_t>(i)] - low) / width * 40), i);
    }
  }
}

TEST(LatinHypercube, TakesWholeNumbersAndListedValuesEquallyOften) {
  const Design design = latin({"pups=2:5", "heading=course,body", "ta=0.1,0.5,0.7"}, 12);
  const auto times = [&](std::size_t a, double value) {
    return std::count(design.axes[a].values.begin(), design.axes[a].values.end(), value);
  };
  for (const double pups : {2, 3, 4, 5}) EXPECT_EQ(times(0, pups), 3);
  for (const double heading : {0, 1}) EXPECT_EQ(times(1, heading), 6);
  for (const double ta : {0.1, 0.5, 0.7}) EXPECT_EQ(times(2, ta), 4);
}

TEST(LatinHypercube, HasAxesWithoutCorrelation) {
  const Design design = latin({"ta=0:1", "beta=0:1"}, 400);
  double sum = 0;
  for (std::size_t i = 0; i < 400; ++i)
    sum += (design.axes[0].values[i] - 0.5) * (design.axes[1].values[i] - 0.5) * 12 / 400;
  EXPECT_LT(std::abs(sum), 0.15);  // three standard errors
}

TEST(LatinHypercube, IsTheSameEverywhereForOneSeed) {
  EXPECT_EQ(latin({"ta=0:1"}, 50, 7).axes[0].values, latin({"ta=0:1"}, 50, 7).axes[0].values);
  EXPECT_NE(latin({"ta=0:1"}, 50, 7).axes[0].values, latin({"ta=0:1"}, 50, 8).axes[0].values);
  // Fixed for ever: a sweep that goes on must find its points.
  EXPECT_EQ(latin({"ta=0:1"}, 3, 1).axes[0].values,
            (std::vector<double>{0.4837383012815127, 0.007008076138909007, 0.7836327045943065}));
}

TEST(LatinHypercube, HasOnePointAtLeast) {
  EXPECT_EQ(latin({"ta=0:1"}, 1).points(), 1);
}

TEST(Span, IsTwoEndsOrAList) {
  EXPECT_TRUE(parse_span("ta=0:1").between);
  EXPECT_FALSE(parse_span("ta=0,1").between);
  for (const char* text : {"ta=0:1", "ta=0.1,0.5", "pups=9:2", "heading=body,course"})
    EXPECT_EQ(span_text(parse_span(text)), text);
}

TEST(Span, ThatIsWrongIsRefusedWithWhatWouldBeRight) {
  const std::pair<const char*, const char*> wrong[] = {{"ta", "name=from:to or name=a,b,c"},
                                                       {"ta=0:1:3", "name=from:to or name=a,b,c"},
                                                       {"ta=1:1", "no range"},
                                                       {"ta=0:x", "'x'"},
                                                       {"heading=0:1", "heading=course,body"},
                                                       {"seed=0:1", "--seeds"},
                                                       {"taa=0:1", "did you mean 'ta'"}};
  for (const auto& pair : wrong) {
    EXPECT_THAT(pupflow::test::failure_of(io::ExitCode::bad_input, [&] { parse_span(pair.first); }),
                HasSubstr(pair.second));
  }
}

}  // namespace
}  // namespace pupflow::study
