// Runs that SIGKILL ends at any moment: final names hold whole files, what is left aside can be read.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <thread>

#include "app/io/checkpoint.h"
#include "app/io/recorded_run.h"
#include "program.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

constexpr int kKills = 50;

class Killed : public testing::Test {
 protected:
  /// Kills such a run within the time that it takes, then calls `look` with what it left aside.
  template <class Look>
  void kill_each(const std::string& option, const std::vector<std::string>& more, Look look) {
    std::vector<std::string> run{"run",     "--set", "pups=3", "--set", "face_points=3",
                                 "--steps", "1200",  option,   "out",   "--quiet"};
    run.insert(run.end(), more.begin(), more.end());
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(pupflow(run).code, 0);
    const auto whole = std::chrono::steady_clock::now() - start;
    std::mt19937 draw(1);
    std::uniform_real_distribution<double> share(0, 1.1);
    for (int kill = 0; kill < kKills; ++kill) {
      clear();
      test::Running running(PUPFLOW_PROGRAM, run, scratch_.folder().string());
      std::this_thread::sleep_for(share(draw) * whole);
      running.signal(SIGKILL);
      const int code = running.wait().code;
      ASSERT_TRUE(code == 0 || code == 128 + SIGKILL) << code;
      const std::vector<std::string> left = unfinished();
      ASSERT_LE(left.size(), 1u);
      killed_ += static_cast<int>(left.size());
      look(left.empty() ? std::string() : left.front());
      if (left.empty()) continue;
      const test::Outcome next = pupflow({"run", "--steps", "1", "--csv", "next", "--quiet"});
      ASSERT_EQ(next.code, 0);
      ASSERT_THAT(next.err, HasSubstr(std::filesystem::path(left.front()).filename().string()));
    }
    std::printf("%d of %d runs left a file aside\n", killed_, kKills);
    EXPECT_GT(killed_, kKills / 10);
  }

  test::Outcome pupflow(const std::vector<std::string>& arguments) const {
    return test::run_program(PUPFLOW_PROGRAM, arguments, scratch_.folder().string());
  }
  std::string out() const { return scratch_.path("out"); }
  bool is_there() const { return std::filesystem::exists(out()); }

  test::Scratch scratch_;
  int killed_ = 0;

 private:
  void clear() const {
    for (const auto& entry : std::filesystem::directory_iterator(scratch_.folder())) {
      std::filesystem::remove(entry.path());
    }
  }
  std::vector<std::string> unfinished() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(scratch_.folder())) {
      if (entry.path().extension() == ".unfinished") names.push_back(entry.path().string());
    }
    return names;
  }
};

TEST_F(Killed, RecordingsCanBeReadAsFarAsTheyWereFlushed) {
  int readable = 0;
  kill_each("--record", {"--record-every", "1"}, [&](const std::string& left) {
    if (is_there()) {
      EXPECT_EQ(io::RecordedRun(out()).frames(), 1200u);
    }
    if (left.empty()) return;
    const test::Outcome info = pupflow({"info", left});
    if (info.code != 0) {
      EXPECT_EQ(info.code, 4);
      EXPECT_THAT(info.err, AnyOf(HasSubstr("before anything was written"),
                                  HasSubstr("ended before its first frames were written")));
      return;
    }
    ++readable;
    EXPECT_THAT(info.out, HasSubstr("unfinished"));
    const io::RecordedRun run(left);
    for (std::size_t i = 0; i < run.frames(); ++i) {
      ASSERT_EQ(run.steps()[i], static_cast<std::int64_t>(i) + 1);
    }
    EXPECT_EQ(pupflow({"verify", left, "--quiet"}).code, 0);
  });
  std::printf("%d of them could be read\n", readable);
  EXPECT_GT(readable, killed_ / 4);
}

TEST_F(Killed, CheckpointsAreThoseOfAStep) {
  kill_each("--checkpoint", {"--checkpoint-every", "100"}, [&](const std::string&) {
    if (is_there()) {
      EXPECT_EQ(io::read_checkpoint(out()).step % 100, 0);
    }
  });
}

TEST_F(Killed, TablesAreWholeOrNotThere) {
  kill_each("--csv", {}, [&](const std::string& left) {
    if (is_there()) {
      EXPECT_THAT(test::contents(out()), HasSubstr("\n# hash = "));
    }
    if (left.empty()) return;
    const test::Outcome info = pupflow({"info", left});
    if (info.code != 0) {
      EXPECT_THAT(info.err, HasSubstr("before anything was written"));
    }
  });
}

}  // namespace
}  // namespace pupflow
