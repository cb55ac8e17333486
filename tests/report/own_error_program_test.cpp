// pupflow report error SCENE, from the command line to the files.
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "app/io/csv.h"
#include "app/io/png.h"
#include "tests/app/program.h"
#include "tests/support/scratch.h"

namespace pupflow::report {
namespace {

using pupflow::test::contents;
using pupflow::test::Outcome;
using pupflow::test::Running;
using pupflow::test::Scratch;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::Pair;
using ::testing::StartsWith;

/// `pupflow report error`, with a small litter and then `words`.
Outcome report_error(const Scratch& scratch, const std::vector<std::string>& words) {
  std::vector<std::string> all{"report",     "error",         "cold",    "--set", "pups=4",
                               "--set",      "face_points=4", "--steps", "80",    "--set",
                               "discard=30", "--out",         "r"};
  all.insert(all.end(), words.begin(), words.end());
  return pupflow::test::run_program(PUPFLOW_PROGRAM, all, scratch.folder().string());
}

TEST(OwnErrorProgram, SaysInWordsHowExactARunIs) {
  const Scratch scratch;
  const Outcome outcome = report_error(scratch, {"--seeds", "4"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(StartsWith("huddling "), HasSubstr("(95 %, 4 seeds, "),
                                 HasSubstr("Half the time: 2 seeds, ± "),
                                 HasSubstr("twice the time: 8 seeds, ± "),
                                 HasSubstr("Halving dt changes it by "), HasSubstr("\nmean_tb 0."),
                                 HasSubstr("\nreport in r/report.md\n")));
  const std::string page = contents(scratch.path("r/report.md"));
  const std::string line = outcome.out.substr(0, outcome.out.find('\n'));
  EXPECT_THAT(page, AllOf(HasSubstr("**" + line + "**"), HasSubstr("| dt = 0.005, consistent |"),
                          HasSubstr("| k = 5 |"), HasSubstr("| float |"), HasSubstr("| explicit |"),
                          HasSubstr("| steps 31 to 160 |"), HasSubstr("| steps 81 to 130 |"),
                          HasSubstr("`pupflow report error cold --set pups=4 ")));
  EXPECT_GT(io::read_png(scratch.path("r/paired.png")).width, 500);
  EXPECT_THAT(io::read_csv_header(scratch.path("r/paired.csv")),
              AllOf(Contains(Pair("pups", "4")), Contains(Pair("ta", "0.2"))));
}

TEST(OwnErrorProgram, TellsALongerRunFromAShorterStepWithoutADiscard) {
  const Scratch scratch;
  const Outcome outcome = report_error(scratch, {"--seeds", "3", "--set", "discard=0"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto change = [&](const std::string& words) {
    const std::size_t begin = outcome.out.find(words) + words.size();
    return outcome.out.substr(begin, outcome.out.find(',', begin) - begin);
  };
  EXPECT_NE(change("Halving dt changes it by "), change("Running twice the steps changes it by "));
}

TEST(OwnErrorProgram, RowsSayWhatIsRefusedAndWhatWentBad) {
  const Scratch scratch;
  const Outcome outcome = report_error(
      scratch, {"--seeds", "2", "--set", "alpha=1", "--set", "k1=300", "--set", "discard=60"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string page = contents(scratch.path("r/report.md"));
  EXPECT_THAT(page, AllOf(HasSubstr("| dt = 0.005, consistent | refused |"),
                          HasSubstr("alpha must be below 1"), HasSubstr("| 40 steps | no means |"),
                          ContainsRegex("\\| euler \\| [^|]*, 2 bad \\|"),
                          HasSubstr("*heat, euler*: 2 of 2 runs failed, the first with diverged")));
}

TEST(OwnErrorProgram, IsAboutTheObservablesAskedFor) {
  const Scratch scratch;
  const Outcome outcome = report_error(scratch, {"--quick", "--observable", "flow"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(StartsWith("flow "), HasSubstr("5 seeds"), Not(HasSubstr("mean_tb"))));
  EXPECT_THAT(contents(scratch.path("r/paired.csv")), Not(HasSubstr("huddling")));
}

TEST(OwnErrorProgram, TakesOnePup) {
  const Scratch scratch;
  const Outcome outcome = report_error(scratch, {"--quick", "--set", "pups=1"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(StartsWith("huddling 0 ± 0 "), HasSubstr("more seeds do not change it")));
}

TEST(OwnErrorProgram, SaysWhenTheRunItselfGoesBad) {
  const Scratch scratch;
  const Outcome outcome =
      report_error(scratch, {"--quick", "--set", "heat=euler", "--set", "k1=900"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, ContainsRegex("5 of 5 runs failed, the first with .* at step"));
  EXPECT_THAT(contents(scratch.path("r/report.md")),
              HasSubstr("huddling: no interval; 5 of 5 runs"));
}

TEST(OwnErrorProgram, RefusesWhatHasNoMeans) {
  const Scratch scratch;
  const auto refused = [&](const std::vector<std::string>& words, const std::string& why) {
    const Outcome outcome = report_error(scratch, words);
    EXPECT_EQ(outcome.code, 2) << why;
    EXPECT_THAT(outcome.err, HasSubstr(why));
    EXPECT_FALSE(std::filesystem::exists(scratch.path("r"))) << why;
  };
  refused({"--set", "pups=0"}, "pups must be at least 1");
  refused({"--set", "discard=80"}, "discard = 80 leaves out all 80 steps");
  refused({"--observable", "hudling"}, "did you mean 'huddling'?");
  refused({"--seed", "9007199254740991"}, "seeds would be too large");
  refused({"--seeds", "1"}, "--seeds");
  refused({"--set", "ta=warm"}, "ta");
}

TEST(OwnErrorProgram, CanBeInterrupted) {
  const Scratch scratch;
  Running running(PUPFLOW_PROGRAM, {"report", "error", "--set", "ta=0.3", "--out", "r"},
                  scratch.folder().string());
  while (!std::filesystem::exists(scratch.path("r"))) ::usleep(20000);
  running.signal(SIGINT);
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
  EXPECT_FALSE(std::filesystem::exists(scratch.path("r/report.md")));
}

}  // namespace
}  // namespace pupflow::report
