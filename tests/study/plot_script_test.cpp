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

TEST(PlotScript, HasFourPanelsForOneParameterAndMapsForTwo) {
  EXPECT_EQ(count(plot_script(small_design({"beta=0,0.5"}, 2)), "  plot "), 4);
  EXPECT_EQ(count(plot_script(small_design({"beta=0,0.5", "ta=0,1"}, 2)), "  plot "), 6);
  EXPECT_EQ(plot_script(small_design({"beta=0,0.5", "ta=0,1", "g=0,1"}, 2)), "");
}

TEST(PlotScript, PlotsOnlyWhatTakesSeveralValues) {
  EXPECT_EQ(plot_script(small_design({"beta=0.5"}, 2)), "");
  EXPECT_EQ(count(plot_script(small_design({"g=0", "beta=0,0.5", "ta=1"}, 2)), "  plot "), 4);
}

TEST(PlotScript, MarksPreferredAndCriticalTemperatureOnTheAxis) {
  Design design = small_design({"ta=0:1:3"}, 2);
  EXPECT_THAT(plot_script(design),
              AllOf(HasSubstr("from 0.6,"), HasSubstr("from 0.53888888"), HasSubstr("'T_{p}'"),
                    HasSubstr("'T_{p} - G/k_{1}'"), HasSubstr("T_{b} = T_{a}")));
  design.base.k1 = 0;  // a lone pup then never cools
  EXPECT_THAT(plot_script(design),
              AllOf(HasSubstr("'T_{p}'"), Not(HasSubstr("G/k_{1}")), Not(HasSubstr("inf"))));
  design.base.tp = 3;
  EXPECT_THAT(plot_script(design), Not(HasSubstr("'T_{p}'")));
  EXPECT_THAT(plot_script(small_design({"beta=0,0.5"}, 2)), Not(HasSubstr("T_{p}")));
}

TEST(PlotScript, SaysWhatTheBandsAre) {
  EXPECT_THAT(plot_script(small_design({"ta=0,1"}, 12)),
              HasSubstr("± 1 standard deviation over 12 seeds"));
  EXPECT_THAT(plot_script(small_design({"ta=0,1"}, 1)), Not(HasSubstr("standard deviation")));
}

}  // namespace
}  // namespace pupflow::study
