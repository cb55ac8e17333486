// Ranks that all work: the same files, errors and exit codes as those of one process.
#include "tests/mpi/mpirun.h"

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

namespace pupflow::mpi::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(Ranks, TwoOrFourGiveTheFilesOfOneProcessToTheByte) {
  ASSERT_EQ(alone(sweep(4, "threads")).code, 0);
  for (const int ranks : {2, 4}) {
    const std::string out = "ranks" + std::to_string(ranks);
    const Outcome outcome = run(mpirun(ranks, sweep(4, out)));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("20 runs in " + out + "/runs.csv\n"));
    EXPECT_EQ(outcome.out.find("20 runs"), outcome.out.rfind("20 runs")) << "said once";
    expect_same("threads", out);
  }
}

TEST_F(Ranks, WithSeveralThreadsEachToo) {
  ASSERT_EQ(alone(sweep(4, "threads")).code, 0);
  EXPECT_EQ(run(mpirun(2, sweep(4, "ranks") + Words{"--threads", "3"})).code, 0);
  expect_same("threads", "ranks");
}

TEST_F(Ranks, SendTheSeriesOfTheirRuns) {
  const Words record{"--record", "--every", "7"};
  ASSERT_EQ(alone(sweep(2, "threads") + record).code, 0);
  ASSERT_TRUE(exists("threads/series/5-2.csv"));
  EXPECT_EQ(run(mpirun(3, sweep(2, "ranks") + record)).code, 0);
  expect_same("threads", "ranks");
}

TEST_F(Ranks, AddSeedsToASweep) {
  ASSERT_EQ(alone(sweep(4, "whole")).code, 0);
  ASSERT_EQ(alone(sweep(2, "s")).code, 0);
  const Outcome outcome = run(mpirun(2, sweep(4, "s")));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("10 runs were there already"));
  expect_same("whole", "s");
}

TEST_F(Ranks, MoreRanksThanRuns) {
  ASSERT_EQ(alone({"sweep", "--vary", "ta=0,1", "--seeds", "1", "--steps", "20", "--set",
                   "discard=5", "--out", "threads"})
                .code,
            0);
  const Outcome outcome = run(mpirun(4, {"sweep", "--vary", "ta=0,1", "--seeds", "1", "--steps",
                                         "20", "--set", "discard=5", "--out", "ranks"}));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  expect_same("threads", "ranks");
}

TEST_F(Ranks, ShareAShard) {
  ASSERT_EQ(alone(sweep(4, "whole")).code, 0);
  EXPECT_EQ(run(mpirun(2, sweep(4, "a") + Words{"--shard", "1/2"})).code, 0);
  EXPECT_EQ(run(mpirun(2, sweep(4, "b") + Words{"--shard", "2/2"})).code, 0);
  ASSERT_EQ(alone({"merge", "a", "b", "--out", "merged"}).code, 0);
  expect_same("whole", "merged");
}

TEST_F(Ranks, ShareNoFolderWithAnotherProcess) {
  Running other(PUPFLOW_PROGRAM, sweep(4000, "s"), folder());
  while (!exists("s/journal.csv")) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const Outcome outcome = run(mpirun(2, sweep(4000, "s")));
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("pupflow: s: another process"));
}

TEST_F(Ranks, AFinishedSweepIsLeftAsItIs) {
  ASSERT_EQ(alone(sweep(2, "s")).code, 0);
  const auto before = files_of("s");
  const Outcome outcome = run(mpirun(2, sweep(2, "s")));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("10 runs were there already"));
  EXPECT_TRUE(before == files_of("s"));
}

TEST_F(Ranks, RunsThatGoWrongEndWithTheSameCodeAndRows) {
  const Words wild{"--set", "heat=euler", "--set", "k1=500"};
  ASSERT_EQ(alone(sweep(1, "threads") + wild).code, 3);
  const Outcome outcome = run(mpirun(2, sweep(1, "ranks") + wild));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("pupflow: 5 of 5 runs failed"));
  expect_same("threads", "ranks");
}

TEST_F(Ranks, OnlyRankZeroPrintsErrors) {
  for (const Words& words :
       {sweep(1, "s") + Words{"--sedes", "2"}, sweep(1, "s") + Words{"--vary", "taa=1"}}) {
    const Outcome outcome = run(mpirun(4, words));
    EXPECT_EQ(outcome.code, 2);
    const std::size_t at = outcome.err.find("did you mean");
    EXPECT_NE(at, std::string::npos);
    EXPECT_EQ(at, outcome.err.rfind("did you mean"));
  }
  EXPECT_FALSE(exists("s"));
}

TEST_F(Ranks, OneThatCannotTakePartIsNamedOnce) {
  const std::vector<std::pair<Words, const char*>> cases{
      {sweep(1, "s") + Words{"--sedes", "2"}, "unknown option '--sedes'"},
      {sweep(1, "s") + Words{"--threads", "0"}, "--threads"},
      {sweep(1, "s") + Words{"--out"}, "--out needs a value"},
      {sweep(1, "s") + Words{"stray", "words"}, "words"}};
  for (const auto& [words, message] : cases) {
    for (const bool first : {false, true}) {
      const Words good = sweep(1, "s"), &one = first ? words : good, &other = first ? good : words;
      const Outcome outcome = run(mpirun(1, one) + Words{":", "-n", "2", PUPFLOW_PROGRAM} + other);
      EXPECT_EQ(outcome.code, 2) << outcome.err;
      const std::size_t at = outcome.err.find("pupflow: ");
      ASSERT_NE(at, std::string::npos) << outcome.err;
      EXPECT_EQ(outcome.err.find("\npupflow: ", at), std::string::npos) << outcome.err;
      EXPECT_THAT(outcome.err.substr(at, outcome.err.find('\n', at)), HasSubstr(message));
    }
  }
  EXPECT_FALSE(exists("s"));
}

TEST_F(Ranks, AFolderThatCannotBeMadeStopsAll) {
  scratch_.file("taken", "a file");
  const Outcome outcome = run(mpirun(4, sweep(1, "taken/s")));
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("taken/s"));
}

TEST_F(Ranks, WithDifferentCommandsAreRefused) {
  const Outcome outcome =
      run(mpirun(1, sweep(1, "a")) + Words{":", "-n", "1", PUPFLOW_PROGRAM} + sweep(1, "b"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--out b'; start independent processes without MPI"));
  EXPECT_FALSE(exists("a"));
}

TEST_F(Ranks, ALauncherThatThisMpiDoesNotKnowIsRefused) {
  const Outcome outcome = run(Words{"PMI_RANK=0", "PMI_SIZE=4", PUPFLOW_PROGRAM} + sweep(1, "s"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("pupflow: started as one of 4 ranks, but"));
  EXPECT_THAT(outcome.err, HasSubstr("sees 1"));
  EXPECT_FALSE(exists("s"));
}

}  // namespace
}  // namespace pupflow::mpi::test
