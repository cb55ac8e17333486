// Sweeps that are killed again and again, and sweeps that are started twice at once.
#include <gmock/gmock.h>

#include <algorithm>
#include <csignal>
#include <random>
#include <thread>

#include "tests/study/sweep_program.h"

namespace pupflow::study::test {
namespace {

using ::testing::AnyOf;
using ::testing::Eq;
using ::testing::HasSubstr;

class Killed : public SweepProgram {
 protected:
  /// Three parameters, so that no figure takes its time; `--record` has more files to break.
  static Words sweep(const std::string& out, int seeds) {
    return small("sweep", {"--vary", "ta=0:1:5", "--vary", "beta=0,0.5", "--vary", "sigma=0,1",
                           "--record", "--every", "20", "--seeds", std::to_string(seeds),
                           "--threads", "2", "--out", out});
  }
};

TEST_F(Killed, FiftyTimesASweepEndsWhereAnUndisturbedOneDoes) {
  expect(0, sweep("whole", 6));
  const auto whole = files_of(path("whole"));
  std::mt19937 generator(50);
  int kills = 0, finished = 0;
  while (kills < 50) {
    Running program(PUPFLOW_PROGRAM, sweep("s", 6), scratch_.folder().string());
    std::this_thread::sleep_for(std::chrono::microseconds(generator() % 90'000));
    program.signal(SIGKILL);
    const Outcome outcome = program.wait();
    ASSERT_THAT(outcome.code, AnyOf(Eq(0), Eq(128 + SIGKILL))) << outcome.err;
    EXPECT_EQ(outcome.err.find("damaged"), std::string::npos);
    kills += outcome.code == 0 ? 0 : 1;
    if (outcome.code != 0) continue;
    ++finished;
    ASSERT_TRUE(files_of(path("s")) == whole);
    std::filesystem::remove_all(path("s"));
  }
  expect(0, sweep("s", 6));
  EXPECT_TRUE(files_of(path("s")) == whole) << finished << " were finished before";
}

TEST_F(Killed, TwoAtOnceDoNoDamage) {
  expect(0, sweep("whole", 1));
  const auto whole = files_of(path("whole"));
  int refused = 0;
  for (int i = 0; i < 30; ++i) {
    std::filesystem::remove_all(path("s"));
    Running one(PUPFLOW_PROGRAM, sweep("s", 1), scratch_.folder().string());
    Running two(PUPFLOW_PROGRAM, sweep("s", 1), scratch_.folder().string());
    std::vector<Outcome> outcomes{one.wait(), two.wait()};
    std::sort(outcomes.begin(), outcomes.end(),
              [](const Outcome& a, const Outcome& b) { return a.code < b.code; });
    ASSERT_EQ(outcomes[0].code, 0) << outcomes[0].err;
    ASSERT_THAT(outcomes[1].code, AnyOf(Eq(0), Eq(4))) << outcomes[1].err;
    if (outcomes[1].code == 4) {
      ++refused;
      EXPECT_THAT(outcomes[1].err, HasSubstr("pupflow: s: another process computes a sweep there"));
      EXPECT_EQ(std::count(outcomes[1].err.begin(), outcomes[1].err.end(), '\n'), 1);
    }
    ASSERT_TRUE(files_of(path("s")) == whole) << i;
  }
  EXPECT_GT(refused, 0);
}

TEST_F(Killed, AnEndedProcessHoldsNoFolder) {
  expect(0, sweep("other", 1));
  Running program(PUPFLOW_PROGRAM, sweep("s", 20), scratch_.folder().string());
  while (!std::filesystem::exists(path("s/journal.csv")))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_THAT(expect(4, sweep("s", 20)), HasSubstr("another process"));
  EXPECT_THAT(expect(4, {"merge", "other", "--out", "s"}), HasSubstr("another process"));
  program.signal(SIGKILL);
  program.wait();
  expect(0, sweep("s", 20));
  EXPECT_FALSE(std::filesystem::exists(path("s/sweep.lock")));
}

}  // namespace
}  // namespace pupflow::study::test
