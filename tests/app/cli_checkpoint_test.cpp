// pupflow run --checkpoint, --from and --record, as a user sees them.
#include <gmock/gmock.h>

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
