#include "app/study/plot_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/study/table.h"
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

TEST(PlotScript, TemperaturesHaveAnAxisInDegrees) {
  const std::string ta = script_of(small_design({"ta=0:1:3"}, 2), {0.2, 0.6, 1.1});
  EXPECT_EQ(count(ta, " set link x2"), 1);
  EXPECT_THAT(ta, HasSubstr("via x*37/0.6 inverse x*0.6/37\n  set x2tics 10 "));
  EXPECT_EQ(count(ta, " set link y2"), 1) << "panel A";
  EXPECT_THAT(script_of(small_design({"tp=0.5:0.6:3"}, 2)), HasSubstr("set x2tics 1 "));
  const std::string beta = script_of(small_design({"beta=0,0.5"}, 2));
  EXPECT_THAT(beta, AllOf(Not(HasSubstr("set link x2")), HasSubstr("set link y2")));
  const std::string map = script_of(small_design({"beta=0,0.5", "ta=0,1"}, 2));
  EXPECT_EQ(count(map, "0.6 is 37 °C"), 4) << "T_a below three panels, T_b over one";
}

TEST(PlotScript, SaysWhatTheBandsAre) {
  EXPECT_THAT(script_of(small_design({"ta=0,1"}, 12)),
              HasSubstr("± 1 standard deviation over 12 seeds"));
  EXPECT_THAT(script_of(small_design({"ta=0,1"}, 1)), Not(HasSubstr("± 1 standard deviation")));
}

TEST(PlotScript, OfMapsSaysWhatTheColorsMean) {
  const auto maps = [](std::int64_t seeds) {
    return script_of(small_design({"beta=0,0.5", "ta=0,1"}, seeds));
  };
  EXPECT_THAT(maps(12), HasSubstr("'means over 12 seeds'"));
  EXPECT_THAT(maps(1), HasSubstr("'one run at each point'"));
  const Design design = small_design({"beta=0,0.5", "ta=0,1"}, 1);
  const std::string script =
      plot_script(design, summarise(design, {test::row_of(0, 1), test::bad_row(1),
                                             test::row_of(2, 1), test::row_of(3, 1)}));
  EXPECT_THAT(script, HasSubstr("blank: no run was fine"));
}

/// The place of the first line that begins so.
std::size_t line_at(const std::string& text, const std::string& beginning) {
  const std::size_t at = text.find("\n" + beginning);
  EXPECT_NE(at, std::string::npos) << beginning;
  return at;
}

TEST(PlotScript, ReadsTheSummaryWhereItsRowsRise) {
  for (const char* ta : {"ta=0.4,0.5,0.6", "ta=0:1:3"}) {
    EXPECT_THAT(script_of(small_design({ta}, 2)),
                AllOf(HasSubstr("plot 'summary.csv' using"), Not(HasSubstr("$summary"))));
  }
  EXPECT_THAT(script_of(small_design({"heading=body,course", "ta=0,1"}, 2)),
              Not(HasSubstr("$summary")));
}

TEST(PlotScript, DrawsUnsortedAndDescendingValuesInRisingOrder) {
  for (const char* ta : {"ta=0.4,0.6,0.5", "ta=0.6,0.5,0.4"}) {
    const std::string script = script_of(small_design({ta}, 2));
    EXPECT_THAT(script, AllOf(HasSubstr("plot $summary using"), Not(HasSubstr("'summary.csv'"))));
    EXPECT_LT(line_at(script, "ta,runs,"), line_at(script, "0.4,2,"));
    EXPECT_LT(line_at(script, "0.4,2,"), line_at(script, "0.5,2,"));
    EXPECT_LT(line_at(script, "0.5,2,"), line_at(script, "0.6,2,"));
  }
  const std::string maps = script_of(small_design({"ta=1,0", "heading=body,course"}, 2));
  EXPECT_LT(line_at(maps, "0,body,"), line_at(maps, "0,course,"));
  EXPECT_LT(line_at(maps, "0,course,"), line_at(maps, "1,body,"));
  EXPECT_THAT(maps, HasSubstr("set ytics ('0' 0, '1' 1)"));
}

TEST(PlotScript, MapsHaveShortLabelsThatDiffer) {
  EXPECT_THAT(script_of(small_design({"ta=0.123456,0.61234567", "v=1000,36461.54"}, 2)),
              AllOf(HasSubstr("set ytics ('0.123' 0, '0.612' 1)"),
                    HasSubstr("set xtics ('1000' 0, '36462' 1)")));
  EXPECT_THAT(script_of(small_design({"ta=0.12345,0.12346", "beta=0,1"}, 2)),
              HasSubstr("('0.12345' 0, '0.12346' 1)"));
}

TEST(PlotScript, OfATableDrawsPointsWhereTheyAre) {
  Design design = small_design({}, 2);
  parse_table("ta,heading\n0.4,body\n0.1,course\n0.3,body\n", "here", design);
  EXPECT_THAT(script_of(design), AllOf(HasSubstr("(column('ta')):(column('mean_tb')) with points"),
                                       HasSubstr("strcol('heading') eq 'body' ? 0")));
  Design line = small_design({}, 2);
  parse_table("ta,beta\n0.4,0.5\n0.1,0.5\n0.4,0.5\n", "here", line);
  EXPECT_EQ(count(script_of(line), "  plot "), 4) << "beta is the same everywhere";
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
