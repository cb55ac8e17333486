// Seeds and series that are added to a sweep.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/study/sweep_program.h"

namespace pupflow::study::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Extended : public SweepProgram {
 protected:
  static Words sweep(const std::string& out, int seeds, const Words& more = {}) {
    Words words{"--vary", "ta=0.1:0.9:3", "--seeds", std::to_string(seeds), "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    return small("sweep", words);
  }

  /// Runs it, and returns what it prints.
  std::string said(const Words& words) const {
    const Outcome outcome = pupflow(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  }
};

TEST_F(Extended, SeedsComputeTheNewOnesAndGiveTheBytesOfAFreshSweep) {
  expect(0, sweep("s", 4));
  EXPECT_THAT(said(sweep("s", 13)), HasSubstr("12 runs were there already\n39 runs in s/runs.csv"));
  expect(0, sweep("fresh", 13));
  EXPECT_EQ(files_of(path("s")), files_of(path("fresh")));
  EXPECT_THAT(expect(2, sweep("s", 12)), HasSubstr("'seeds = 13' there, 'seeds = 12' now"));
}

TEST_F(Extended, RowsThatWereThereAreTaken) {
  expect(0, sweep("s", 2));
  // A number that no run comes to, in a row that is otherwise as it was.
  std::string runs = contents(path("s/runs.csv"));
  const std::size_t begin = runs.find(",fine,") + 6;
  runs.replace(begin, runs.find(',', begin) - begin, "0.125");
  scratch_.file("s/runs.csv", runs);
  expect(0, sweep("s", 3));
  EXPECT_THAT(contents(path("s/runs.csv")), HasSubstr(",fine,0.125,"));
}

TEST_F(Extended, SeedsAreAddedToAnInterruptedSweep) {
  Running program(PUPFLOW_PROGRAM, sweep("s", 200, {"--threads", "1"}), scratch_.folder().string());
  const auto begun = [&] {
    return std::filesystem::exists(path("s/journal.csv")) &&
           !contents(path("s/journal.csv")).empty();
  };
  for (int wait = 0; !begun() && wait < 20'000; ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  program.signal(SIGINT);
  EXPECT_EQ(program.wait().code, 130);
  EXPECT_THAT(said(sweep("s", 203)), HasSubstr(" runs were there already\n609 runs"));
  expect(0, sweep("fresh", 203));
  EXPECT_EQ(files_of(path("s")), files_of(path("fresh")));
}

TEST_F(Extended, AScriptThatTheUserEditedStays) {
  expect(0, sweep("s", 2));
  const std::string script = contents(path("s/sweep.gp"));
  scratch_.file("s/sweep.gp", "# mine\n" + script);
  expect(0, sweep("s", 3));
  EXPECT_EQ(contents(path("s/sweep.gp")), "# mine\n" + script);
}

TEST_F(Extended, ShardsAreNot) {
  expect(0, sweep("s", 2, {"--shard", "1/2"}));
  EXPECT_THAT(expect(2, sweep("s", 3, {"--shard", "1/2"})), HasSubstr("'seeds = 2' there"));
}

class Recorded : public Extended {
 protected:
  static Words record(const std::string& out, int seeds, const Words& more = {}) {
    Words words{"--record", "--every", "7"};
    words.insert(words.end(), more.begin(), more.end());
    return sweep(out, seeds, words);
  }
};

TEST_F(Recorded, HasTheMetricsOfEachRun) {
  EXPECT_THAT(said(record("s", 2)), HasSubstr("series in s/series\n"));
  const auto rows = rows_of(path("s/runs.csv"));
  ASSERT_EQ(rows.size(), 6u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    expect(0, small("run", {"--set", "ta=" + rows[i][0], "--seed", rows[i][1], "--csv", "run.csv",
                            "--every", "7", "--force", "--quiet"}));
    const std::string name = std::to_string(i / 2 + 1) + "-" + std::to_string(i % 2 + 1) + ".csv";
    EXPECT_EQ(contents(path("s/series/" + name)), contents(path("run.csv"))) << name;
  }
  expect(0, {"run", "--like", "s/summary.csv", "--quiet"});
  expect(0, sweep("plain", 2));
  EXPECT_EQ(rows_of(path("plain/runs.csv")), rows);
}

TEST_F(Recorded, TellsWhyASeriesEndsEarly) {
  const Words wild{"--vary", "k1=500", "--set", "heat=euler", "--seeds",
                   "1",      "--out",  "s",     "--record"};
  expect(3, small("sweep", wild));
  const std::string seed = rows_of(path("s/runs.csv"))[0][1];
  expect(3, small("run", {"--set", "heat=euler", "--set", "k1=500", "--seed", seed, "--csv",
                          "run.csv", "--quiet"}));
  EXPECT_THAT(contents(path("run.csv")), HasSubstr("# ended early: diverged"));
  EXPECT_EQ(contents(path("s/series/1-1.csv")), contents(path("run.csv")));
}

TEST_F(Recorded, ARunIsDoneOnlyWhenItsSeriesIsThere) {
  expect(0, record("s", 2));
  const auto files = files_of(path("s"));
  std::filesystem::remove(path("s/series/1-2.csv"));
  std::filesystem::remove(path("s/series/3-1.csv"));
  EXPECT_THAT(said(record("s", 2)), HasSubstr("4 runs were there already"));
  EXPECT_EQ(files_of(path("s")), files);
  EXPECT_THAT(said(record("s", 2)), HasSubstr("6 runs were there already"));
}

TEST_F(Recorded, KeepsItsSeriesWhenSeedsAreAdded) {
  expect(0, record("s", 2));
  EXPECT_THAT(said(record("s", 11)), HasSubstr("6 runs were there already"));
  expect(0, record("fresh", 11));
  EXPECT_EQ(files_of(path("s")), files_of(path("fresh")));
}

TEST_F(Recorded, MayBeWhatIsAdded) {
  expect(0, sweep("s", 2));
  EXPECT_THAT(said(record("s", 2)), Not(HasSubstr("already")));
  expect(0, record("fresh", 2));
  EXPECT_EQ(files_of(path("s")), files_of(path("fresh")));
  EXPECT_THAT(expect(2, sweep("s", 2)), HasSubstr("'record_every = 7' there"));
}

TEST_F(Recorded, IsMerged) {
  expect(0, record("a", 3, {"--shard", "1/2"}));
  expect(0, record("b", 3, {"--shard", "2/2"}));
  expect(0, {"merge", "a", "b", "--out", "joined"});
  expect(0, record("whole", 3));
  EXPECT_EQ(files_of(path("joined")), files_of(path("whole")));
  std::filesystem::remove(path("b/series/1-2.csv"));
  EXPECT_THAT(expect(4, {"merge", "a", "b", "--out", "again"}), HasSubstr("b/series/1-2.csv"));
}

TEST_F(Recorded, DoesNotMixWithSomebodysSeries) {
  std::filesystem::create_directories(path("s/series"));
  scratch_.file("s/series/1-1.csv", "somebody's");
  EXPECT_THAT(expect(4, record("s", 2)), AllOf(HasSubstr("s/series"), HasSubstr("--force")));
  EXPECT_EQ(contents(path("s/series/1-1.csv")), "somebody's");
}

}  // namespace
}  // namespace pupflow::study::test
