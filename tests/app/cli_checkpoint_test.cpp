// pupflow run --checkpoint, --from and --record, as a user sees them.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "app/io/checkpoint.h"
#include "app/io/recorded_run.h"
#include "program.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class CliCheckpoint : public testing::Test {
 protected:
  test::Outcome run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "run");
    return test::run_program(PUPFLOW_PROGRAM, arguments, scratch_.folder().string());
  }
  std::vector<std::string> small(std::vector<std::string> more) const {
    more.insert(more.begin(), {"--set", "pups=3", "--set", "face_points=3"});
    return more;
  }
  test::Scratch scratch_;
};

TEST_F(CliCheckpoint, ASplitRunGivesTheRowsOfAWholeOne) {
  ASSERT_EQ(run(small({"--steps", "90", "--csv", "whole.csv", "--quiet"})).code, 0);
  ASSERT_EQ(
      run(small({"--steps", "50", "--csv", "first.csv", "--checkpoint", "c.h5", "--quiet"})).code,
      0);
  const test::Outcome second =
      run({"--from", "c.h5", "--steps", "90", "--csv", "second.csv", "--quiet"});
  ASSERT_EQ(second.code, 0) << second.err;
  const std::string whole = test::contents(scratch_.path("whole.csv"));
  const std::string rows = test::contents(scratch_.path("second.csv"));
  const std::string from_51 = rows.substr(rows.find("\n51,"));
  EXPECT_THAT(whole, EndsWith(from_51));
}

TEST_F(CliCheckpoint, TheSummaryNamesTheStepsThatItsMeansAreOver) {
  ASSERT_EQ(
      run(small({"--set", "discard=10", "--steps", "50", "--checkpoint", "c.h5", "--quiet"})).code,
      0);
  EXPECT_THAT(run({"--from", "c.h5", "--steps", "90"}).out, HasSubstr("means over steps 51 to 90"));
}

TEST_F(CliCheckpoint, WhoTouchesWhomGoesOnFromARunThatNobodyWatched) {
  // So small an arena that they lie on each other: groups that are there before and after.
  const auto crowded = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"--set", "arena_radius=0.4"});
    return small(more);
  };
  ASSERT_EQ(run(crowded({"--steps", "210", "--csv", "whole.csv", "--quiet"})).code, 0);
  ASSERT_EQ(run(crowded({"--steps", "200", "--checkpoint", "c.h5", "--quiet"})).code, 0);
  ASSERT_EQ(run({"--from", "c.h5", "--steps", "210", "--csv", "second.csv", "--quiet"}).code, 0);
  const std::string rows = test::contents(scratch_.path("second.csv"));
  EXPECT_THAT(test::contents(scratch_.path("whole.csv")),
              EndsWith(rows.substr(rows.find("\n201,"))));
}

TEST_F(CliCheckpoint, ParametersMayChangeButNotTheLitter) {
  ASSERT_EQ(run(small({"--steps", "20", "--checkpoint", "c.h5", "--quiet"})).code, 0);
  EXPECT_EQ(run({"--from", "c.h5", "--steps", "30", "--set", "ta=0.9", "--quiet"}).code, 0);
  const test::Outcome other = run({"--from", "c.h5", "--set", "pups=4", "--quiet"});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("c.h5"));
  EXPECT_EQ(run({"cold", "--from", "c.h5"}).code, 2);
}

TEST_F(CliCheckpoint, OutputsAreNotOverwritten) {
  scratch_.file("c.h5", "mine");
  scratch_.file("r.h5", "mine");
  EXPECT_EQ(run(small({"--steps", "20", "--checkpoint", "c.h5", "--quiet"})).code, 4);
  EXPECT_EQ(run(small({"--steps", "20", "--record", "r.h5", "--quiet"})).code, 4);
  EXPECT_EQ(test::contents(scratch_.path("c.h5")), "mine");
}

TEST_F(CliCheckpoint, IsWrittenAsTheRunGoes) {
  ASSERT_EQ(run(small({"--steps", "20", "--checkpoint", "twenty.h5", "--quiet"})).code, 0);
  // Numbers that go wrong in step 21: the checkpoint is the one before.
  const test::Outcome wrong =
      run(small({"--steps", "60", "--checkpoint", "c.h5", "--checkpoint-every", "10", "--at",
                 "step=20,pup=1,force=[1e300,0,0]", "--quiet"}));
  ASSERT_EQ(wrong.code, 3) << wrong.err;
  EXPECT_EQ(io::read_checkpoint(scratch_.path("c.h5")).step, 20);
  EXPECT_EQ(io::read_checkpoint(scratch_.path("c.h5")).positions,
            io::read_checkpoint(scratch_.path("twenty.h5")).positions);
}

TEST_F(CliCheckpoint, IsTheLastStateWhereTheRunEnds) {
  ASSERT_EQ(
      run(small({"--steps", "25", "--checkpoint", "c.h5", "--checkpoint-every", "10", "--quiet"}))
          .code,
      0);
  EXPECT_EQ(io::read_checkpoint(scratch_.path("c.h5")).step, 25);
  const test::Outcome alone = run(small({"--steps", "5", "--checkpoint-every", "10"}));
  EXPECT_EQ(alone.code, 2);
  EXPECT_THAT(alone.err, HasSubstr("--checkpoint-every: has no effect without --checkpoint"));
  for (const char* number : {"0", "-1", "x", ""}) {
    EXPECT_EQ(run(small({"--checkpoint", "d.h5", "--checkpoint-every", number})).code, 2) << number;
  }
}

TEST_F(CliCheckpoint, WhatCannotBeWrittenIsRefusedBeforeTheFirstStep) {
  // So many steps that the test would time out.
  const auto refused = [&](int code, std::vector<std::string> outputs) {
    outputs.insert(outputs.end(), {"--steps", "1000000000", "--quiet"});
    const test::Outcome outcome = run(small(outputs));
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    return outcome.err;
  };
  for (const char* device : {"/dev/null", "-", "/dev/stdout", "/dev/full"}) {
    EXPECT_THAT(refused(4, {"--checkpoint", device}), HasSubstr("name a file"));
    EXPECT_THAT(refused(4, {"--record", device}), HasSubstr("name a file"));
  }
  std::filesystem::create_symlink("nothing", scratch_.path("link"));
  const char* const options[] = {"--csv", "--pups", "--record", "--checkpoint"};
  for (const char* option : options) {
    EXPECT_THAT(refused(4, {option, "link"}), HasSubstr("link to a file that is not there"));
    EXPECT_THAT(refused(4, {option, "no/file"}), HasSubstr("no folder"));
    EXPECT_THAT(refused(4, {option, std::string(250, 'n')}), HasSubstr("name is too long"));
    EXPECT_THAT(refused(4, {option, "."}), HasSubstr("is a folder"));
    for (const char* other : options) {
      if (std::string(option) == other) continue;
      EXPECT_THAT(refused(2, {option, "same", other, "./same"}), HasSubstr("name two files"));
    }
  }
  scratch_.file("one", "");
  std::filesystem::create_hard_link(scratch_.path("one"), scratch_.path("two"));
  EXPECT_THAT(refused(2, {"--csv", "one", "--record", "two", "--force"}),
              HasSubstr("--csv and --record both go to one"));
  EXPECT_EQ(scratch_.entries(), 3);
}

TEST_F(CliCheckpoint, ARecordingThatFillsTheDiskStaysReadable) {
  const std::string limited =
      "ulimit -f 1500; exec " PUPFLOW_PROGRAM
      " run --set pups=3 --set face_points=2 --steps 1000000 --record r.h5 --record-every 1 "
      "--record-fields tb --quiet";
  const test::Outcome full =
      test::run_program("/bin/sh", {"-c", limited}, scratch_.folder().string());
  EXPECT_EQ(full.code, 4);
  EXPECT_EQ(std::count(full.err.begin(), full.err.end(), '\n'), 1) << full.err;
  const std::size_t name = full.err.find("r.h5.");
  ASSERT_NE(name, std::string::npos) << full.err;
  const std::string left = full.err.substr(name, full.err.find('\n') - name);
  const io::RecordedRun recorded(scratch_.path(left));
  EXPECT_GT(recorded.frames(), 0u);
  EXPECT_FALSE(std::filesystem::exists(scratch_.path("r.h5")));
}

TEST_F(CliCheckpoint, ARecordingCanBeReadWhileItGrows) {
  const test::Running running(PUPFLOW_PROGRAM,
                              {"run", "--set", "pups=3", "--set", "face_points=3", "--steps",
                               "1000000000", "--record", "r.h5", "--record-every", "1", "--quiet"},
                              scratch_.folder().string());
  std::size_t frames = 0;
  for (int look = 0; look < 300 && frames < 100; ++look) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const std::filesystem::directory_iterator first(scratch_.folder());
    if (first == std::filesystem::directory_iterator()) continue;
    const std::string name = first->path().string();
    if (test::run_program(PUPFLOW_PROGRAM, {"info", name}, "/").code != 0) continue;  // not begun
    frames = io::RecordedRun(name).frames();
  }
  EXPECT_GE(frames, 100u);
}

TEST_F(CliCheckpoint, ARecordingSaysHowItWasMade) {
  ASSERT_EQ(run(small({"--steps", "20", "--record", "r.h5", "--record-every", "5", "--csv", "a.csv",
                       "--quiet"}))
                .code,
            0);
  ASSERT_EQ(run({"--like", "r.h5", "--csv", "b.csv", "--quiet"}).code, 0);
  EXPECT_EQ(test::contents(scratch_.path("a.csv")), test::contents(scratch_.path("b.csv")));
}

}  // namespace
}  // namespace pupflow
