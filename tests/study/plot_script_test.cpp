#include "app/study/plot_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/study/small_design.h"

namespace pupflow::study {
namespace {

using test::small_design;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

int count(const std::string& text, const std::string& word) {
  int found = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size()) {
    ++found;
  }
  return found;
}

/// The script of a design whose points have these mean body temperatures (0 where none is given).
std::string script_of(const Design& design, const std::vector<double>& mean_tb = {}) {
  std::vector<Row> rows;
  for (std::int64_t run = 0; run < design.runs(); ++run) {
    rows.push_back(test::row_of(run, 0));
    if (!mean_tb.empty())
      rows.back().means.mean_tb = mean_tb[static_cast<std::size_t>(run / design.seeds)];
  }
  return plot_script(design, summarise(design, rows));
}

TEST(PlotScript, HasFourPanelsForOneParameterAndMapsForTwo) {
  EXPECT_EQ(count(script_of(small_design({"beta=0,0.5"}, 2)), "  plot "), 4);
  EXPECT_EQ(count(script_of(small_design({"beta=0,0.5", "ta=0,1"}, 2)), "  plot "), 6);
  EXPECT_EQ(script_of(small_design({"beta=0,0.5", "ta=0,1", "g=0,1"}, 2)), "");
}

TEST(PlotScript, PlotsOnlyWhatTakesSeveralValues) {
  EXPECT_EQ(script_of(small_design({"beta=0.5"}, 2)), "");
  EXPECT_EQ(count(script_of(small_design({"g=0", "beta=0,0.5", "ta=1"}, 2)), "  plot "), 4);
}

TEST(PlotScript, MarksPreferredAndCriticalTemperatureOnTheAxis) {
  Design design = small_design({"ta=0:1:3"}, 2);
  EXPECT_THAT(script_of(design),
              AllOf(HasSubstr("from 0.6,"), HasSubstr("from 0.53888888"), HasSubstr("'T_{p}'"),
                    HasSubstr("'T_{p} - G/k_{1}'"), HasSubstr("T_{b} = T_{a}")));
  design.base.air_conductance = 0;  // a lone pup then never cools
  EXPECT_THAT(script_of(design),
              AllOf(HasSubstr("'T_{p}'"), Not(HasSubstr("G/k_{1}")), Not(HasSubstr("inf"))));
  design.base.preferred_temperature = 3;
  EXPECT_THAT(script_of(design), Not(HasSubstr("'T_{p}'")));
  EXPECT_THAT(script_of(small_design({"beta=0,0.5"}, 2)), Not(HasSubstr("T_{p}")));
}

TEST(PlotScript, SaysWhatTheBandsAre) {
  EXPECT_THAT(script_of(small_design({"ta=0,1"}, 12)),
              HasSubstr("± 1 standard deviation over 12 seeds"));
  EXPECT_THAT(script_of(small_design({"ta=0,1"}, 1)), Not(HasSubstr("± 1 standard deviation")));
}

TEST(PlotScript, ShadesInAllPanelsWhereTheLitterHoldsItsTemperature) {
  const std::string script = script_of(small_design({"ta=0:3:4"}, 1), {0.6, 0.2, 0.6, 0.6});
  EXPECT_THAT(script, AllOf(HasSubstr("set object 1 rectangle from 0, graph 0 to 0.07"),
                            HasSubstr("set object 2 rectangle from 1.92"),
                            HasSubstr("'shaded: mean T_{b} within 0.03 of T_{p}'")));
  EXPECT_THAT(script, Not(HasSubstr("unset object")));
  EXPECT_THAT(script_of(small_design({"ta=0:3:4"}, 2), {0.2, 0.2, 0.2, 0.2}),
              AllOf(Not(HasSubstr("set object")), Not(HasSubstr("shaded"))));
  EXPECT_THAT(script_of(small_design({"beta=0,0.5"}, 1), {0.6, 0.6}), Not(HasSubstr("shaded")));
}

TEST(PlotScript, DrawsFlowAndStandardDeviationOnTwoAxes) {
  Design design = small_design({"ta=0,1"}, 2);
  EXPECT_THAT(script_of(design),
              AllOf(HasSubstr("|ΔA|/Δt over 1 step "), HasSubstr("set y2label 'standard dev"),
                    HasSubstr("(column('exposed_sd')) axes x1y2")));
  design.base.flow_lag = 10;
  EXPECT_THAT(script_of(design), HasSubstr("|ΔA|/Δt over 10 steps "));
}

TEST(PlotScript, AxesStartAtZeroOrSayThatTheyDoNot) {
  const std::string script = script_of(small_design({"ta=-1,1"}, 2), {0.1, 0.6});
  EXPECT_EQ(count(script, "set yrange [0:*]"), 4);
  EXPECT_THAT(script, AllOf(HasSubstr("set y2range [0:*]"), Not(HasSubstr("does not start"))));
  const std::string below = script_of(small_design({"ta=-1,1"}, 2), {-0.9, 0.6});
  EXPECT_EQ(count(below, "set yrange [0:*]"), 3);
  EXPECT_THAT(below, HasSubstr("'this axis does not start at 0'"));
}

}  // namespace
}  // namespace pupflow::study
