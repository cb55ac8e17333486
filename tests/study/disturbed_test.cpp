// What survives a kill, Ctrl-C, a full disk, and folders that cannot be written to.
#include <gmock/gmock.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "app/study/journal.h"
#include "tests/study/sweep_program.h"

namespace pupflow::study::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::ptrdiff_t lines_in(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

std::ptrdiff_t lines_of(const std::string& path) {
  return std::filesystem::exists(path) ? lines_in(contents(path)) : 0;
}

class Disturbed : public SweepProgram {
 protected:
  /// Enough runs to be caught in the middle.
  static Words sweep(const std::string& out) {
    return small("sweep", {"--vary", "ta=0:1:20", "--seeds", "20", "--threads", "2", "--out", out});
  }

  /// Starts the sweep and sends `signal` once some runs are finished.
  Outcome disturbed_by(int signal) const {
    Running program(PUPFLOW_PROGRAM, sweep("s"), scratch_.folder().string());
    for (int wait = 0; lines_of(path("s/journal.csv")) < 3 && wait < 20'000; ++wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    program.signal(signal);
    return program.wait();
  }

  /// Going on with the sweep ends where an undisturbed one does, to the byte.
  void expect_to_end_as_if_undisturbed(const std::string& said) const {
    const Outcome resumed = pupflow(sweep("s"));
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_THAT(resumed.out, HasSubstr(said));
    expect(0, sweep("whole"));
    EXPECT_EQ(files_of(path("s")), files_of(path("whole")));
  }
};

TEST_F(Disturbed, AKilledSweepGoesOnToTheSameBytes) {
  EXPECT_EQ(disturbed_by(SIGKILL).code, 128 + SIGKILL);
  EXPECT_THAT(names_of(path("s")), ElementsAre("journal.csv", "manifest.toml", "sweep.lock"));
  const std::ptrdiff_t kept = lines_of(path("s/journal.csv"));
  EXPECT_GE(kept, 3);
  EXPECT_LT(kept, 400);
  expect_to_end_as_if_undisturbed(std::to_string(kept) + " runs were there already");
}

TEST_F(Disturbed, ACutOffOrDamagedLastLineIsComputedAgain) {
  disturbed_by(SIGKILL);
  const std::string journal = contents(path("s/journal.csv"));
  const std::size_t last = journal.rfind('\n', journal.size() - 2) + 1;
  scratch_.file("s/journal.csv", journal.substr(0, last + (journal.size() - last) / 2));
  const std::ptrdiff_t kept = lines_of(path("s/journal.csv"));
  expect_to_end_as_if_undisturbed(std::to_string(kept) + " runs were there already");
}

TEST_F(Disturbed, FinishedRunsAreNotComputedAgain) {
  disturbed_by(SIGKILL);
  // A number that no run comes to, in a row that is otherwise as it was.
  {
    const Design design = parse_manifest(contents(path("s/manifest.toml")), "manifest.toml");
    Journal journal(path("s/journal.csv"), design);
    Row row = journal.rows().begin()->second;
    row.means.mean_tb = 0.125;
    journal.add(row);
  }
  expect(0, sweep("s"));
  EXPECT_THAT(contents(path("s/runs.csv")), HasSubstr(",fine,0.125,"));
}

TEST_F(Disturbed, CtrlCAndItsLikesKeepFinishedRunsAndEndWith130) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    std::filesystem::remove_all(path("s"));
    const Outcome outcome = disturbed_by(signal);
    EXPECT_EQ(outcome.code, 130);
    EXPECT_THAT(names_of(path("s")), ElementsAre("journal.csv", "manifest.toml"));
    const std::string kept = std::to_string(lines_of(path("s/journal.csv")));
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("interrupted with " + kept + " of 400 runs finished"),
                                   HasSubstr("the same command computes the others")));
    expect_to_end_as_if_undisturbed(kept + " runs were there already");
  }
}

TEST_F(Disturbed, DamagedRowsAreComputedAgainAndCounted) {
  disturbed_by(SIGKILL);
  std::string journal = contents(path("s/journal.csv"));
  const std::string kept = std::to_string(lines_in(journal) - 1);
  char& digit = journal[journal.find(',') - 1];
  digit = digit == '1' ? '2' : '1';
  scratch_.file("s/journal.csv", journal);
  const Outcome resumed = pupflow(sweep("s"));
  EXPECT_EQ(resumed.code, 0);
  EXPECT_THAT(resumed.err,
              StartsWith("pupflow: note: 1 damaged row of s/journal.csv is computed again\n"));
  EXPECT_THAT(resumed.out, HasSubstr(kept + " runs were there already"));
  expect(0, sweep("whole"));
  EXPECT_EQ(files_of(path("s")), files_of(path("whole")));
}

TEST_F(Disturbed, AFullDiskKeepsFinishedRuns) {
  // A limit on file sizes stands in for it: 2 blocks of 512 bytes hold some rows of the journal.
  const Outcome full = pupflow_behind("ulimit -f 2; exec env --default-signal=XFSZ", sweep("s"));
  EXPECT_EQ(full.code, 4) << full.err;
  EXPECT_THAT(full.err, AllOf(HasSubstr("s/journal.csv"), HasSubstr("cannot write")));
  const std::ptrdiff_t kept = lines_of(path("s/journal.csv"));
  EXPECT_GE(kept, 3);
  expect_to_end_as_if_undisturbed(std::to_string(kept) + " runs were there already");
}

TEST_F(Disturbed, ADiskThatFillsUpAtTheEndLosesNoRun) {
  // All runs are in the journal; runs.csv, which is made from it, does not fit.
  expect(0, sweep("s"));
  const Design design = parse_manifest(contents(path("s/manifest.toml")), "manifest.toml");
  {
    Journal journal(path("s/journal.csv"), design);
    for (const Row& row : read_runs(path("s/runs.csv"), design)) journal.add(row);
  }
  const std::string journal = contents(path("s/journal.csv"));
  for (const char* name : {"s/runs.csv", "s/summary.csv"}) std::filesystem::remove(path(name));
  const Outcome full = pupflow_behind("ulimit -f 8; exec env --default-signal=XFSZ", sweep("s"));
  EXPECT_EQ(full.code, 4) << full.err;
  EXPECT_THAT(full.err, HasSubstr("s/runs.csv: cannot write"));
  EXPECT_EQ(contents(path("s/journal.csv")), journal);
  EXPECT_FALSE(std::filesystem::exists(path("s/runs.csv")));
  expect_to_end_as_if_undisturbed("400 runs were there already");
}

TEST_F(Disturbed, FoldersThatCannotBeWrittenToAreRefusedBeforeAnythingRuns) {
  scratch_.file("taken", "a file");
  for (const std::string folder : {"taken", "taken/s", "/proc/s", "/dev/null/s"}) {
    EXPECT_THAT(expect(4, sweep(folder)), HasSubstr(folder + ": cannot make this folder"));
  }
  EXPECT_EQ(contents(path("taken")), "a file");
  EXPECT_THAT(expect(4, sweep("/proc")), HasSubstr("/proc/sweep.lock"));
}

}  // namespace
}  // namespace pupflow::study::test
