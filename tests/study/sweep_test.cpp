// From the command line to the files, undisturbed.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/study/sweep_program.h"

namespace pupflow::study::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

class Sweep : public SweepProgram {};

TEST_F(Sweep, WritesTheSameBytesOnAnyNumberOfThreads) {
  const Words range{"--vary", "ta=0:1:4", "--vary", "heading=course,body", "--seeds", "3"};
  for (const std::string threads : {"1", "2", "8"}) {
    Words words = range;
    words.insert(words.end(), {"--threads", threads, "--out", "t" + threads});
    expect(0, small("sweep", words));
  }
  const auto one = files_of(path("t1"));
  EXPECT_THAT(names_of(path("t1")), ElementsAre("manifest.toml", "runs.csv", "summary.csv",
                                                "sweep.gp", "sweep.png", "sweep.svg"));
  EXPECT_EQ(files_of(path("t2")), one);
  EXPECT_EQ(files_of(path("t8")), one);
  EXPECT_THAT(rows_of(path("t1/runs.csv")), SizeIs(24));
  EXPECT_THAT(rows_of(path("t1/summary.csv")), SizeIs(8));
}

/// Means of a metrics CSV's columns from row `from` on.
std::vector<double> means_of(const std::string& csv, std::size_t from) {
  const auto rows = rows_of(csv);
  std::vector<double> means(rows[0].size());
  for (std::size_t r = from; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < means.size(); ++c) {
      means[c] += std::stod(rows[r][c]) / static_cast<double>(rows.size() - from);
    }
  }
  return means;
}

TEST_F(Sweep, OfAnotherFlowLagIsAnotherSweep) {
  const Words lag{"--vary", "ta=0,1", "--seeds", "2", "--flow-lag"};
  const auto with = [&](const std::string& steps, const std::string& folder) {
    Words words = lag;
    words.insert(words.end(), {steps, "--out", folder});
    return small("sweep", words);
  };
  expect(0, with("1", "one"));
  expect(0, with("10", "ten"));
  EXPECT_THAT(expect(2, with("10", "one")), HasSubstr("'flow_lag = 1' there, 'flow_lag = 10' now"));
  const auto one = rows_of(path("one/runs.csv")), ten = rows_of(path("ten/runs.csv"));
  for (std::size_t i = 0; i < one.size(); ++i) {
    Words other = ten[i];
    EXPECT_NE(other[7], one[i][7]);  // flow
    other[7] = one[i][7];
    EXPECT_EQ(other, one[i]) << "the other means are over the same steps";
  }
  expect(0, small("sweep", {"--like", "ten/summary.csv", "--vary", "ta=0,1", "--seeds", "2",
                            "--out", "like"}));
  EXPECT_EQ(files_of(path("like")), files_of(path("ten")));
}

TEST_F(Sweep, HasRowsThatASingleRunComesToAgain) {
  expect(0, small("sweep", {"--vary", "ta=0.1:0.9:3", "--vary", "beta=0,0.5", "--seeds", "2",
                            "--seed", "77", "--out", "s"}));
  const auto rows = rows_of(path("s/runs.csv"));
  ASSERT_THAT(rows, SizeIs(12));
  for (const Words& row : rows) {
    expect(0, small("run", {"--set", "ta=" + row[0], "--set", "beta=" + row[1], "--seed", row[2],
                            "--csv", "run.csv", "--force", "--quiet"}));
    EXPECT_EQ(row[3], "fine");
    const std::vector<double> means = means_of(path("run.csv"), 20);
    for (std::size_t i = 0; i < 6; ++i) {  // metrics have step and time in front
      const double value = std::stod(row[4 + i]);
      EXPECT_NEAR(means[2 + i], value, 1e-12 * (1 + std::abs(value)));
    }
  }
}

TEST_F(Sweep, CanBeMadeAgainFromAnyOfItsFiles) {
  expect(0, small("sweep", {"--vary", "ta=0,1", "--seeds", "2", "--set", "heading=body", "--seed",
                            "5", "--out", "s"}));
  for (const std::string file : {"runs.csv", "summary.csv", "sweep.png"}) {
    expect(0, {"sweep", "--like", "s/" + file, "--vary", "ta=0,1", "--seeds", "2", "--out",
               file + "2"});
    EXPECT_EQ(files_of(path(file + "2")), files_of(path("s"))) << file;
  }
}

TEST_F(Sweep, SaysNothingWhenQuiet) {
  const Outcome outcome = pupflow(small("sweep", {"--vary", "ta=0,1", "--seeds", "2", "--quiet"}));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_TRUE(std::filesystem::exists(path("sweep/summary.csv")));
}

TEST_F(Sweep, IsTakenFromThereWhenItIsDone) {
  const Words words = small("sweep", {"--vary", "ta=0,1", "--seeds", "2"});
  expect(0, words);
  const auto files = files_of(path("sweep"));
  const Outcome again = pupflow(words);
  EXPECT_EQ(again.code, 0);
  EXPECT_THAT(again.out, HasSubstr("4 runs were there already"));
  EXPECT_EQ(files_of(path("sweep")), files);
}

TEST_F(Sweep, RefusesToGoOnWithOtherParameters) {
  const Words range{"--vary", "ta=0,1", "--seeds", "2", "--out", "s"};
  expect(0, small("sweep", range));
  const auto files = files_of(path("s"));
  Words other = range;
  other.insert(other.end(), {"--set", "beta=0.25"});
  EXPECT_THAT(expect(2, small("sweep", other)),
              AllOf(HasSubstr("'beta = 0.5' there, 'beta = 0.25' now"), HasSubstr("--out"),
                    HasSubstr("--force")));
  EXPECT_EQ(files_of(path("s")), files);
  other.push_back("--force");
  expect(0, small("sweep", other));
  EXPECT_NE(files_of(path("s")), files);
}

TEST_F(Sweep, RecordsRunsThatGoWrongAndEndsWithThree) {
  const Words words{"sweep",      "--set",      "pups=3",     "--set",   "face_points=3",
                    "--set",      "heat=euler", "--steps",    "300",     "--set",
                    "discard=20", "--vary",     "k1=0.9,500", "--seeds", "2",
                    "--out",      "s"};
  const std::string said = expect(3, words);
  EXPECT_THAT(said, AllOf(HasSubstr("2 of 4 runs failed"), HasSubstr("run 2 (seed "),
                          HasSubstr("diverged at step"), HasSubstr("stage heat")));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1);
  const auto rows = rows_of(path("s/runs.csv"));
  ASSERT_THAT(rows, SizeIs(4));
  EXPECT_EQ(rows[1][2], "fine");
  EXPECT_THAT(rows[2][2], HasSubstr("diverged"));
  EXPECT_THAT(rows[2][3], "nan");
  const auto summary = rows_of(path("s/summary.csv"));
  EXPECT_EQ(summary[0][1], "2");
  EXPECT_EQ(summary[0][summary[0].size() - 2], "0");
  EXPECT_EQ(summary[1][1], "0");
  EXPECT_EQ(summary[1][summary[1].size() - 2], "2");
  EXPECT_TRUE(std::filesystem::exists(path("s/sweep.png")));
  expect(3, words);  // also when it is only read again
}

TEST_F(Sweep, KeepsRunsWithAWarningAndSaysSo) {
  const Outcome outcome = pupflow(
      small("sweep", {"--vary", "drive=1,60", "--seeds", "2", "--steps", "200", "--out", "wall"}));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("warning: 2 of 4 runs ended with a warning and are in "
                                     "the means; the first, run 2 (seed "));
  const auto runs = rows_of(path("wall/runs.csv")), points = rows_of(path("wall/summary.csv"));
  EXPECT_EQ(runs[0][2], "fine");
  EXPECT_THAT(runs[2][2], StartsWith("fine; outside the wall from step "));
  EXPECT_NE(runs[2][3], "nan");
  EXPECT_EQ(points[0].back(), "0");
  EXPECT_EQ(points[1].back(), "2");
  EXPECT_EQ(points[1][1], "2");
  expect(0, small("sweep", {"--vary", "drive=1,60", "--seeds", "2", "--steps", "200", "--shard",
                            "1/2", "--out", "a"}));
  expect(0, small("sweep", {"--vary", "drive=1,60", "--seeds", "2", "--steps", "200", "--shard",
                            "2/2", "--out", "b"}));
  expect(0, {"merge", "a", "b", "--out", "joined"});
  EXPECT_EQ(contents(path("joined/runs.csv")), contents(path("wall/runs.csv")));
  EXPECT_EQ(contents(path("joined/summary.csv")), contents(path("wall/summary.csv")));
}

TEST_F(Sweep, DrawsNothingWhenNoRunWasFine) {
  const Outcome outcome = pupflow({"sweep", "--set", "pups=3", "--set", "face_points=3", "--set",
                                   "heat=euler", "--set", "k1=500", "--steps", "300", "--set",
                                   "discard=20", "--vary", "ta=0,1", "--seeds", "2", "--out", "s"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.out, HasSubstr("no plot: no run was fine"));
  EXPECT_THAT(names_of(path("s")), ElementsAre("manifest.toml", "runs.csv", "summary.csv"));
}

TEST_F(Sweep, RefusesWrongOptionsBeforeItRuns) {
  const std::pair<Words, const char*> wrong[] = {
      {{}, "--vary"},
      {{"--vary", "ta=0:1"}, "from:to:count"},
      {{"--vary", "tb=0,1"}, "'tb0'"},
      {{"--vary", "ta=0,1", "--vary", "ta=2"}, "twice"},
      {{"--vary", "ta=0,1", "--seeds", "0"}, "1 to 1000000"},
      {{"--vary", "ta=0,1", "--shard", "3/2"}, "1 to n"},
      {{"--vary", "ta=0,1", "--threads", "0"}, "--threads"},
      {{"--vary", "ta=0,1", "--set", "discard=60"}, "must exceed discard"},
      {{"--vary", "ta=0,1", "--flow-lag", "61"}, "it must be at most steps = 60"},
      {{"--vary", "ta=0,1", "--flow-lag", "none"}, "--flow-lag: flow_lag = 'none'"},
      {{"--vary", "ta=0,1", "--out", ""}, "--out"},
  };
  for (const auto& [words, said] : wrong) {
    EXPECT_THAT(expect(2, small("sweep", words)), HasSubstr(said));
  }
  EXPECT_EQ(scratch_.entries(), 0);
}

}  // namespace
}  // namespace pupflow::study::test
