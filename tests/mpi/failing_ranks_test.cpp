// Ranks that are killed, hang or are interrupted: no finished run is lost.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <optional>
#include <stdexcept>
#include <thread>

#include "tests/mpi/mpirun.h"

namespace pupflow::mpi::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Long enough to be disturbed in the middle: mpirun forwards a signal after a second. A sanitizer makes a
// step ten times as long.
constexpr int kSeeds = 40;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kSteps = 600;
#else
constexpr int kSteps = 6000;
#endif

class FailingRanks : public Ranks {
 protected:
  /// Waits until some runs are finished.
  void wait_for_runs() const {
    for (int wait = 0; wait < 30'000; ++wait) {
      if (exists("s/journal.csv")) {
        const std::string journal = contents(scratch_.path("s/journal.csv"));
        if (std::count(journal.begin(), journal.end(), '\n') >= 3) return;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    FAIL() << "no run was finished";
  }

  /// The process of one rank of the job in this folder.
  pid_t process_of(int rank) const {
    const std::string variable = "OMPI_COMM_WORLD_RANK=" + std::to_string(rank);
    for (const auto& entry : fs::directory_iterator("/proc")) {
      std::error_code other_users;
      if (fs::read_symlink(entry.path() / "exe", other_users) != PUPFLOW_PROGRAM) continue;
      if (fs::read_symlink(entry.path() / "cwd", other_users) != scratch_.folder()) continue;
      const std::string environment = '\0' + contents((entry.path() / "environ").string());
      if (environment.find('\0' + variable + '\0') != std::string::npos)
        return std::stoi(entry.path().filename().string());
    }
    throw std::runtime_error("no such rank");
  }

  /// Starts the sweep on `ranks` ranks and, in the middle, sends `signal` to one of them or to
  /// mpirun.
  Outcome disturbed(int ranks, int signal, std::optional<int> rank, const Words& options = {}) {
    Running job("/usr/bin/env", mpirun(ranks, sweep(kSeeds, "s", kSteps), options), folder());
    wait_for_runs();
    if (rank) {
      ::kill(process_of(*rank), signal);
    } else {
      job.signal(signal);
    }
    return job.wait();
  }

  void expect_whole() const {
    ASSERT_EQ(alone(sweep(kSeeds, "undisturbed", kSteps)).code, 0);
    expect_same("undisturbed", "s");
  }

  /// Expects that the job was cut off, and that the same command computes the missing runs.
  void expect_resumed(int ranks) const {
    EXPECT_FALSE(exists("s/runs.csv"));
    const Outcome outcome = run(mpirun(ranks, sweep(kSeeds, "s", kSteps)));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(" runs were there already\n"));
    expect_whole();
  }
};

TEST_F(FailingRanks, WithRecoveryOtherRanksComputeTheRunsOfAKilledOne) {
  const Outcome outcome = disturbed(4, SIGKILL, 2, {"--enable-recovery"});
  EXPECT_THAT(outcome.err, HasSubstr("pupflow: rank 2 is lost: no message for 1 s"));
  expect_whole();
}

TEST_F(FailingRanks, WithoutRecoveryAKilledRankEndsTheJobAndTheSameCommandResumes) {
  const Outcome outcome = disturbed(2, SIGKILL, 1);
  EXPECT_NE(outcome.code, 0);
  expect_resumed(4);
}

TEST_F(FailingRanks, RankZeroKilledEndsTheJobAndTheSameCommandResumes) {
  const Outcome outcome = disturbed(2, SIGKILL, 0, {"--enable-recovery"});
  EXPECT_THAT(outcome.err, HasSubstr("rank 1 stops: no message from rank 0 for 1 s"));
  expect_resumed(2);
}

TEST_F(FailingRanks, OneThatHangsIsLostAndEndedWithTheJob) {
  const Outcome outcome = disturbed(4, SIGSTOP, 3);
  // On a busy machine Open MPI's mpirun may say 1: it saw the rank that hung die before rank 0 ended.
  EXPECT_THAT(outcome.code, testing::AnyOf(0, 1)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("pupflow: rank 3 is lost: no message for 1 s"));
  EXPECT_THAT(outcome.out, HasSubstr("200 runs in s/runs.csv\n"));
  expect_whole();
}

TEST_F(FailingRanks, OneThatWasPausedIsLostAndComesBack) {
  Running job("/usr/bin/env", mpirun(4, sweep(kSeeds, "s", kSteps)), folder());
  wait_for_runs();
  const pid_t paused = process_of(3);
  ::kill(paused, SIGSTOP);
  std::this_thread::sleep_for(std::chrono::seconds(3));
  ::kill(paused, SIGCONT);
  const Outcome outcome = job.wait();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("pupflow: rank 3 is lost: no message for 1 s"));
  EXPECT_THAT(outcome.err, HasSubstr("pupflow: rank 3 is back"));
  expect_whole();
}

TEST_F(FailingRanks, InterruptedTheyKeepFinishedRuns) {
  for (const int signal : {SIGINT, SIGTERM}) {
    fs::remove_all(scratch_.path("s"));
    const Outcome outcome = disturbed(2, signal, std::nullopt);
    EXPECT_NE(outcome.code, 0);
    EXPECT_THAT(outcome.err,
                HasSubstr("of 200 runs finished; the same command computes the others"));
    EXPECT_FALSE(exists("s/runs.csv"));
  }
  expect_resumed(2);
}

TEST_F(FailingRanks, RankZeroInterruptedEndsTheJobWithItsCode) {
  EXPECT_EQ(disturbed(2, SIGTERM, 0).code, 130);
  expect_resumed(2);
}

}  // namespace
}  // namespace pupflow::mpi::test
