#include "app/study/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/failing.h"
#include "tests/study/small_design.h"
#include "tests/support/scratch.h"

namespace pupflow::study {
namespace {

using io::ExitCode;
using pupflow::test::failure_of;
using pupflow::test::Scratch;
using ::testing::HasSubstr;

const std::string kNames =
    "ta,runs,mean_tb,mean_tb_sd,huddling,huddling_sd,groups,groups_sd,largest,largest_sd,flow,"
    "flow_sd\n";

class Compared : public ::testing::Test {
 protected:
  Comparison of(const std::string& a, const std::string& b) {
    return compare_summaries(scratch_.file("a.csv", a), scratch_.file("b.csv", b));
  }
  std::string refused(const std::string& a, const std::string& b) {
    return failure_of(ExitCode::bad_input, [&] { of(a, b); });
  }
  const Scratch scratch_;
};

TEST_F(Compared, AFileDiffersFromItselfByNothing) {
  const Design design = test::small_design({"ta=0,1"}, 2);
  const std::string path = scratch_.path("summary.csv");
  write_summary(path, design,
                summarise(design, {test::row_of(0, 1), test::row_of(1, 2), test::row_of(2, 3),
                                   test::row_of(3, 5)}));
  const Comparison comparison = compare_summaries(path, path);
  EXPECT_EQ(comparison.differences.size(), 2 * kObservableCount);
  EXPECT_EQ(comparison.beyond_three, 0);
  EXPECT_EQ(comparison.rms, 0);
  EXPECT_EQ(comparison.largest_tb, 0);
}

TEST_F(Compared, AFolderIsItsSummary) {
  const std::string row = kNames + "0,2,1,1,1,1,1,1,1,1,1,1\n";
  for (const char* name : {"a", "b", "shard", "other"})
    std::filesystem::create_directory(scratch_.path(name));
  scratch_.file("a/summary.csv", row);
  scratch_.file("b/summary.csv", row);
  scratch_.file("shard/manifest.toml", "");
  EXPECT_EQ(compare_summaries(scratch_.path("a"), scratch_.path("b")).differences.size(), 5u);
  EXPECT_EQ(compare_summaries(scratch_.path("a/"), scratch_.path("b/summary.csv")).rms, 0);
  const auto refused_folder = [&](const char* name) {
    return failure_of(ExitCode::bad_input,
                      [&] { compare_summaries(scratch_.path("a"), scratch_.path(name)); });
  };
  EXPECT_THAT(refused_folder("shard"), HasSubstr("not finished, or one of several shards"));
  EXPECT_THAT(refused_folder("other"), HasSubstr("no folder of a sweep"));
}

TEST_F(Compared, DifferencesAreInCombinedStandardErrors) {
  // mean_tb: errors 3/sqrt(9) = 1 and 8/sqrt(16) = 2, together sqrt(5). flow: 4/sqrt(9), 0.
  const Comparison comparison = of("# a comment\n" + kNames + "0,9,10,3,1,1,2,1,3,1,0,4\n",
                                   kNames + "0.000000,16,0,8,1,1,2,1,3,1,5,0\r\n");
  EXPECT_NEAR(comparison.differences[0].standard_errors, 10 / std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(comparison.differences[4].standard_errors, -3.75, 1e-12);
  EXPECT_EQ(comparison.beyond_three, 2);
  EXPECT_NEAR(comparison.rms, std::sqrt((100 / 5.0 + 3.75 * 3.75) / 5), 1e-12);
  EXPECT_EQ(comparison.largest_tb, 10);
  EXPECT_NEAR(comparison.largest_tb_errors, 10 / std::sqrt(5.0), 1e-12);
  const std::string text = comparison_text(comparison);
  EXPECT_THAT(text, HasSubstr("+4.5"));
  EXPECT_THAT(text, HasSubstr("-3.8"));
  EXPECT_THAT(
      text,
      HasSubstr("2 of 5 points beyond 3, rms 2.61, mean_tb within 10.0000 and 4.5 standard errors\n"
                "membership_flow was not compared: it is not in both files\n"));
  EXPECT_THAT(comparison_text(comparison, true), HasSubstr("within 10.0000 (616.67 °C) and"));
}

TEST_F(Compared, PointsWithoutSpreadAreCountedApart) {
  const std::string one = kNames + "0,1,1,nan,1,nan,1,nan,1,nan,1,nan\n1,2,1,1,1,1,1,1,1,1,1,1\n";
  const std::string two = kNames + "0,2,2,1,2,1,2,1,2,1,2,1\n1,2,1,1,1,1,1,1,1,1,1,1\n";
  const Comparison comparison = of(one, two);
  EXPECT_EQ(comparison.unknown, 5);
  EXPECT_EQ(comparison.rms, 0);
  EXPECT_THAT(comparison_text(comparison),
              HasSubstr("0 of 5 points beyond 3, 5 unknown: fewer than two runs"));
}

TEST_F(Compared, FilesThatDoNotFitTogetherAreRefused) {
  const std::string row = ",2,1,1,1,1,1,1,1,1,1,1\n", good = kNames + "0" + row;
  EXPECT_THAT(refused(good, good + "1" + row), HasSubstr("has 2 rows"));
  EXPECT_THAT(refused(good, kNames + "0.001" + row), HasSubstr("row 1 has ta = 0.001, not 0"));
  EXPECT_THAT(refused(good, "beta" + kNames.substr(2) + "0" + row), HasSubstr("same parameters"));
  EXPECT_THAT(refused(good, "beta," + kNames + "0,0" + row), HasSubstr("same parameters"));
  EXPECT_THAT(refused("beta," + kNames + "0,0" + row, good), HasSubstr("same parameters"));
  EXPECT_THAT(refused(good, "ta,seed,status\n0,1,fine\n"), HasSubstr("no column runs"));
  EXPECT_THAT(refused(good, ""), HasSubstr("no column runs"));
  EXPECT_THAT(refused(good, kNames + "0,2,1\n"),
              HasSubstr(".csv:2: has 3 cells, and the header 12"));
  EXPECT_THAT(refused(kNames, kNames), HasSubstr("has no rows to compare"));
  EXPECT_THAT(refused(good, kNames + "0,2,x,1,1,1,1,1,1,1,1,1\n"), HasSubstr("'x'"));
  EXPECT_THAT(refused(good, "ta,runs,mean_tb\n0,2,1\n"), HasSubstr("no observable"));
  EXPECT_THAT(
      failure_of(ExitCode::bad_file,
                 [&] { compare_summaries(scratch_.path("none.csv"), scratch_.path("a.csv")); }),
      HasSubstr("none.csv"));
}

}  // namespace
}  // namespace pupflow::study
