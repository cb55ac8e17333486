#include "app/study/results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "app/study/table.h"
#include "tests/app/failing.h"
#include "tests/study/small_design.h"
#include "tests/support/scratch.h"

namespace pupflow::study {
namespace {

using io::ExitCode;
using pupflow::test::contents;
using pupflow::test::failure_of;
using pupflow::test::Scratch;
using test::bad_row;
using test::row_of;
using test::small_design;
using test::warned_row;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(RunRow, ReadsBackToTheSameNumbers) {
  const Design design = small_design({"ta=0:1:4", "heading=course,body"}, 3);
  Row row = row_of(22, 1.0 / 3);
  row.means.flow = 1e-300;
  row.exposed_sd = std::numeric_limits<double>::quiet_NaN();
  const std::string text = row_text(design, row);
  EXPECT_THAT(text, StartsWith("1,body," + std::to_string(run_seed(1, 71)) + ",fine,"));
  const auto back = parse_row(design, 22, text);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->run, 22);
  EXPECT_TRUE(back->fine());
  for (std::size_t i = 0; i < kRunStatisticCount - 1; ++i)
    EXPECT_EQ(statistic(*back, i), statistic(row, i));
  EXPECT_TRUE(std::isnan(back->exposed_sd));
  EXPECT_EQ(row_text(design, *back), text);
}

TEST(RunRow, KeepsWhereARunWentWrongInOneCell) {
  const Design design = small_design({"ta=0,1"}, 1);
  const Row row = bad_row(1);
  EXPECT_FALSE(row.fine());
  EXPECT_THAT(row.status, HasSubstr("step 12"));
  EXPECT_THAT(row.status, HasSubstr("shape_match"));
  const std::string text = row_text(design, row);
  EXPECT_EQ(std::count(text.begin(), text.end(), ','), 2 + std::ptrdiff_t{kRunStatisticCount});
  const auto back = parse_row(design, 1, text);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->status, row.status);
  EXPECT_TRUE(std::isnan(back->means.flow));
}

TEST(RunRow, WithAWarningIsFineAndReadsBack) {
  const Design design = small_design({"ta=0,1"}, 1);
  const Row row = warned_row(1, 3);
  EXPECT_TRUE(row.fine());
  EXPECT_TRUE(row.warned());
  EXPECT_FALSE(row_of(1, 3).warned());
  EXPECT_FALSE(bad_row(1).warned());
  EXPECT_EQ(row.status,
            "fine; outside the wall from step 74 pup 4; hanging in the air from step 150 pup 2");
  const std::string text = row_text(design, row);
  const auto back = parse_row(design, 1, text);
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->warned());
  EXPECT_EQ(row_text(design, *back), text);
}

TEST(RunRow, ThatWentWrongNamesItsWarningsToo) {
  RunResult result;
  result.status = {Status::Kind::diverged, Stage::predict, 302, 0, 286};
  result.warnings.add({Warning::Kind::gaining_energy, 185, 0});
  const Row row = make_row(0, result);
  EXPECT_FALSE(row.fine());
  EXPECT_FALSE(row.warned());
  EXPECT_THAT(row.status, ::testing::EndsWith("point 286; gaining energy from step 185 pup 0"));
}

TEST(RunRow, IsRefusedWhenDamagedOrOfAnotherRun) {
  const Design design = small_design({"ta=0,1"}, 2);
  const std::string text = row_text(design, row_of(3, 0.25));
  ASSERT_TRUE(parse_row(design, 3, text));
  EXPECT_FALSE(parse_row(design, 2, text));
  EXPECT_FALSE(parse_row(small_design({"ta=0,0.9"}, 2), 3, text));
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_FALSE(parse_row(design, 3, text.substr(0, length) + "x")) << length;
  }
  EXPECT_FALSE(parse_row(design, 3, text + ","));
  EXPECT_FALSE(parse_row(design, 3, text + ",1"));
  EXPECT_FALSE(parse_row(design, 3, ""));
}

TEST(RunColumns, AreThoseThatScriptsReadByName) {
  EXPECT_EQ(runs_columns(small_design({"ta=0,1", "beta=0,1"}, 1)),
            "ta,beta,seed,status,mean_tb,huddling,groups,largest,flow,membership_flow,exposed_sd");
}

TEST(Summaries, HoldMeanAndSampleDeviationOfTheFineRuns) {
  const Design design = small_design({"alpha=0.5,0.7"}, 4);
  const std::vector<Row> rows{row_of(0, 1), row_of(1, 2), bad_row(2), row_of(3, 6),
                              bad_row(4),   bad_row(5),   bad_row(6), row_of(7, 5)};
  const std::vector<Summary> summaries = summarise(design, rows);
  ASSERT_EQ(summaries.size(), 2u);
  EXPECT_EQ(summaries[0].runs, 3);
  EXPECT_EQ(summaries[0].failed, 1);
  for (std::size_t c = 0; c < kRunStatisticCount; ++c) {
    EXPECT_DOUBLE_EQ(summaries[0].statistics[c].mean, 3 + static_cast<double>(c));
    EXPECT_DOUBLE_EQ(summaries[0].statistics[c].sd, std::sqrt((4. + 1 + 9) / 2));
  }
  EXPECT_EQ(summaries[1].runs, 1);
  EXPECT_EQ(summaries[1].failed, 3);
  EXPECT_DOUBLE_EQ(summaries[1].statistics[0].mean, 5);
  EXPECT_TRUE(std::isnan(summaries[1].statistics[0].sd));  // one run has no spread
  EXPECT_TRUE(std::isnan(summaries[0].susceptibility));    // ta is not varied
}

TEST(Summaries, CountRunsWithAWarningAmongTheFine) {
  const std::vector<Summary> summaries = summarise(
      small_design({"ta=0.5"}, 4), {row_of(0, 1), warned_row(1, 3), bad_row(2), warned_row(3, 5)});
  EXPECT_EQ(summaries[0].runs, 3);
  EXPECT_EQ(summaries[0].failed, 1);
  EXPECT_EQ(summaries[0].warned, 2);
  EXPECT_DOUBLE_EQ(summaries[0].statistics[0].mean, 3);
}

TEST(Summaries, WithoutAFineRunHaveNoMean) {
  const std::vector<Summary> summaries =
      summarise(small_design({"ta=0.5"}, 2), {bad_row(0), bad_row(1)});
  EXPECT_EQ(summaries[0].runs, 0);
  EXPECT_EQ(summaries[0].failed, 2);
  EXPECT_TRUE(std::isnan(summaries[0].statistics[4].mean));
}

/// Rows of one seed whose huddling is `of(point)`.
template <class Of>
std::vector<Row> huddling_rows(const Design& design, Of of) {
  std::vector<Row> rows;
  for (std::int64_t run = 0; run < design.runs(); ++run) {
    rows.push_back(row_of(run, 0));
    rows.back().means.huddling = of(design.values_at(run));
  }
  return rows;
}

TEST(Susceptibility, IsTheSlopeOfExposureAlongAmbientTemperature) {
  const Design design = small_design({"ta=0,0.5,0.75,1"}, 1);
  const auto summaries =
      summarise(design, huddling_rows(design, [](const auto& at) { return at[0] * at[0]; }));
  EXPECT_NEAR(summaries[0].susceptibility, 0.5, 1e-12);   // (0.25 - 0) / 0.5, one-sided
  EXPECT_NEAR(summaries[1].susceptibility, 0.75, 1e-12);  // (0.5625 - 0) / 0.75
  EXPECT_NEAR(summaries[2].susceptibility, 1.5, 1e-12);   // (1 - 0.25) / 0.5
  EXPECT_NEAR(summaries[3].susceptibility, 1.75, 1e-12);
}

TEST(Susceptibility, TakesOnlyAmbientTemperatureForItsNeighbours) {
  const auto of = [](const std::vector<double>& at) { return -3 * at[1] + 100 * at[0] + at[2]; };
  const Design design = small_design({"beta=0,0.5", "ta=0:1:3", "alpha=0.1,0.2"}, 1);
  for (const Summary& summary : summarise(design, huddling_rows(design, of))) {
    EXPECT_NEAR(summary.susceptibility, 3, 1e-9);
  }
}

TEST(Susceptibility, TakesNeighboursByValueInAnyOrderOfTheValues) {
  const auto square = [](const auto& at) { return at[0] * at[0]; };
  const auto of = [&](const std::string& vary) {
    const Design design = small_design({vary}, 1);
    std::map<double, double> slopes;
    for (const Summary& summary : summarise(design, huddling_rows(design, square)))
      slopes[summary.values[0]] = summary.susceptibility;
    return slopes;
  };
  const auto rising = of("ta=0.4,0.5,0.6");
  EXPECT_NEAR(rising.at(0.4), 0.9, 1e-12);
  EXPECT_NEAR(rising.at(0.5), 1.0, 1e-12);
  EXPECT_EQ(of("ta=0.4,0.6,0.5"), rising);
  EXPECT_EQ(of("ta=0.6,0.5,0.4"), rising);
}

Design table_design(const std::string& text) {
  Design design = small_design({}, 1);
  parse_table(text, "here", design);
  return design;
}

TEST(Susceptibility, OfATableIsBetweenRowsThatDifferInNothingElse) {
  const Design design = table_design("ta,beta\n0,0.1\n0.5,0.2\n1,0.1\n0.7,0.3\n0.7,0.3\n");
  Design one_seed = design;
  one_seed.seeds = 1;
  const auto summaries = summarise(
      one_seed, huddling_rows(one_seed, [](const auto& at) { return 3 * at[0] + 100 * at[1]; }));
  EXPECT_NEAR(summaries[0].susceptibility, 3, 1e-12);
  EXPECT_TRUE(std::isnan(summaries[1].susceptibility));
  EXPECT_NEAR(summaries[2].susceptibility, 3, 1e-12);
  EXPECT_TRUE(std::isnan(summaries[3].susceptibility));
}

TEST(Summaries, OfATableWithSeedsAreOverTheRowsOfEqualParameters) {
  const Design design = table_design("ta,seed\n0.5,1\n0.1,1\n0.5,2\n0.5,9\n");
  const auto summaries = summarise(design, {row_of(0, 1), row_of(1, 7), row_of(2, 3), bad_row(3)});
  ASSERT_EQ(summaries.size(), 2u);
  EXPECT_EQ(summaries[0].values, std::vector<double>{0.5});
  EXPECT_EQ(summaries[0].runs, 2);
  EXPECT_EQ(summaries[0].failed, 1);
  EXPECT_DOUBLE_EQ(summaries[0].statistics[0].mean, 2);
  EXPECT_EQ(summaries[1].runs, 1);
  EXPECT_EQ(seeds_text(summaries), "1 to 3 seeds");
  EXPECT_EQ(row_text(design, row_of(2, 3)).substr(0, 11), "0.5,2,fine,");
}

TEST(Summaries, OfATableWithoutSeedsAreOneForEachRow) {
  Design design = table_design("ta\n0.5\n0.5\n");
  design.seeds = 2;
  const auto summaries =
      summarise(design, {row_of(0, 1), row_of(1, 3), row_of(2, 5), row_of(3, 7)});
  ASSERT_EQ(summaries.size(), 2u);
  EXPECT_DOUBLE_EQ(summaries[1].statistics[0].mean, 6);
  EXPECT_EQ(seeds_text(summaries), "2 seeds");
}

TEST(RunsFile, ReadsBackAndRefusesWhatIsNotWhole) {
  const Scratch scratch;
  const Design design = small_design({"ta=0,1"}, 2);
  const std::vector<Row> rows{row_of(0, 1), bad_row(1), row_of(2, 3), row_of(3, 0.1)};
  const std::string path = scratch.path("runs.csv");
  write_runs(path, design, rows);
  const std::string text = contents(path);
  EXPECT_THAT(text, HasSubstr("\n# ta = 0.4\n"));
  const std::vector<Row> back = read_runs(path, design);
  ASSERT_EQ(back.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(row_text(design, back[i]), row_text(design, rows[i]));
  }

  const auto refused = [&](const std::string& bytes) {
    scratch.file("runs.csv", bytes);
    return failure_of(ExitCode::bad_input, [&] { read_runs(path, design); });
  };
  const std::size_t last = text.rfind('\n', text.size() - 2) + 1;
  EXPECT_THAT(refused(text.substr(0, last)), HasSubstr("holds 3 of 4 runs"));
  EXPECT_THAT(refused(text + text.substr(last)), HasSubstr("damaged or of another sweep"));
  EXPECT_THAT(refused(text.substr(0, text.size() - 1) + "x\n"), HasSubstr("damaged"));
  std::string renamed = text;
  renamed.replace(renamed.find(",flow,"), 6, ",flew,");
  EXPECT_THAT(refused(renamed), HasSubstr("columns"));
}

TEST(SummaryFile, HasMeansDeviationsSusceptibilityAndFailures) {
  const Scratch scratch;
  const Design design = small_design({"ta=0,1"}, 2);
  const std::string path = scratch.path("summary.csv");
  write_summary(path, design,
                summarise(design, {row_of(0, 1), row_of(1, 3), row_of(2, 4), bad_row(3)}));
  const std::string text = contents(path);
  EXPECT_THAT(text, HasSubstr("\nta,runs,mean_tb,mean_tb_sd,huddling,huddling_sd,groups,groups_sd,"
                              "largest,largest_sd,flow,flow_sd,membership_flow,membership_flow_sd,"
                              "exposed_sd,exposed_sd_sd,susceptibility,failed,warned\n"));
  EXPECT_THAT(text, HasSubstr("\n0,2,2,1.4142135623730951,3,"));
  EXPECT_THAT(text, HasSubstr("\n1,1,4,nan,5,nan,6,nan,7,nan,8,nan,9,nan,10,nan,2,1,0\n"));
}

}  // namespace
}  // namespace pupflow::study
