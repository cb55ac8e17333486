// pupflow run --record and pupflow export, as a user types them; recordings_test.py reads the
// exports back.
#include <gmock/gmock.h>

#include "app/io/recorded_run.h"
#include "program.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class CliExport : public testing::Test {
 protected:
  test::Outcome pupflow(const std::vector<std::string>& arguments) const {
    return test::run_program(PUPFLOW_PROGRAM, arguments, scratch_.folder().string());
  }

  /// Records a small litter with options `more`.
  test::Outcome record(const std::string& name, const std::vector<std::string>& more) const {
    std::vector<std::string> call{"run",     "--set", "pups=3",  "--set",    "face_points=2",
                                  "--steps", "20",    "--quiet", "--record", name};
    call.insert(call.end(), more.begin(), more.end());
    return pupflow(call);
  }

  std::vector<std::int64_t> steps_of(const std::string& name) const {
    return io::RecordedRun(scratch_.path(name)).steps();
  }

  /// The one line of an export that must fail with `code`.
  std::string refused(int code, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "export");
    const test::Outcome outcome = pupflow(arguments);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    return outcome.err;
  }

  test::Scratch scratch_;
};

TEST_F(CliExport, FramesAreThoseThatWereAskedFor) {
  ASSERT_EQ(record("a.h5", {}).code, 0);
  EXPECT_THAT(steps_of("a.h5"), ElementsAre(10, 20));
  ASSERT_EQ(record("b.h5", {"--record-from", "0", "--record-every", "8"}).code, 0);
  EXPECT_THAT(steps_of("b.h5"), ElementsAre(0, 8, 16));
  ASSERT_EQ(record("c.h5", {"--record-from", "17", "--record-every", "2"}).code, 0);
  EXPECT_THAT(steps_of("c.h5"), ElementsAre(17, 19));
  ASSERT_EQ(record("d.h5", {"--record-from", "21"}).code, 0);
  EXPECT_THAT(steps_of("d.h5"), IsEmpty());
}

TEST_F(CliExport, ARunThatGoesOnRecordsItsStartWhereThatIsAskedFor) {
  ASSERT_EQ(record("a.h5", {"--checkpoint", "c.h5"}).code, 0);
  const std::vector<std::string> on{"run",      "--from", "c.h5",           "--steps", "40",
                                    "--record", "b.h5",   "--record-every", "10",      "--quiet"};
  ASSERT_EQ(pupflow(on).code, 0);
  EXPECT_THAT(steps_of("b.h5"), ElementsAre(30, 40));
  std::vector<std::string> with_start = on;
  with_start[6] = "e.h5";
  with_start.insert(with_start.end(), {"--record-from", "0"});
  ASSERT_EQ(pupflow(with_start).code, 0);
  EXPECT_THAT(steps_of("e.h5"), ElementsAre(20, 30, 40));
}

TEST_F(CliExport, ARecordingCarriesTheScheduleAndTheStateAtItsEnd) {
  ASSERT_EQ(record("a.h5", {"--at", "step=5,ta=0.7", "--csv", "a.csv"}).code, 0);
  const std::string info = pupflow({"info", "a.h5"}).out;
  EXPECT_THAT(info, testing::ContainsRegex("at +step=5,ta=0.7\n"));
  EXPECT_THAT(info, testing::ContainsRegex("step +20\n"));
  EXPECT_THAT(info, testing::ContainsRegex("hash +[0-9a-f]{16}\n"));
  ASSERT_EQ(pupflow({"run", "--like", "a.h5", "--csv", "b.csv", "--quiet"}).code, 0);
  EXPECT_EQ(test::contents(scratch_.path("a.csv")), test::contents(scratch_.path("b.csv")));
}

TEST_F(CliExport, WrongNamesOfFieldsAreRefusedBeforeTheRun) {
  const test::Outcome outcome = record("a.h5", {"--record-fields", "pup,temprature"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'temperature'"));
  EXPECT_EQ(scratch_.entries(), 0);
}

TEST_F(CliExport, AFullDiskIsReportedAndLeavesNothing) {
  const std::string call =
      "ulimit -f 64; exec \"$0\" run --set pups=4 --steps 400 --quiet --record r.h5 "
      "--record-every 1 --record-fields pup,afferent,point";
  const test::Outcome outcome =
      test::run_program("/bin/bash", {"-c", call, PUPFLOW_PROGRAM}, scratch_.folder().string());
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_THAT(outcome.err, testing::MatchesRegex("pupflow: r.h5: [^\n]+\n"));
  EXPECT_EQ(scratch_.entries(), 0);
}

TEST_F(CliExport, SaysWhatIsWrongAndWhatWouldBeRight) {
  ASSERT_EQ(record("pup.h5", {}).code, 0);
  ASSERT_EQ(record("all.h5", {"--record-fields", "pup,afferent,point"}).code, 0);
  scratch_.file("text.h5", "no HDF5");
  EXPECT_THAT(refused(4, {"text.h5", "--format", "npy", "--out", "o.npy"}), HasSubstr("text.h5"));
  EXPECT_THAT(refused(4, {"none.h5", "--format", "npy", "--out", "o.npy"}), HasSubstr("none.h5"));
  EXPECT_THAT(refused(2, {"pup.h5", "--format", "csv", "--out", "o"}),
              HasSubstr("npy, timedarray, gcal, vtk"));
  EXPECT_THAT(refused(2, {"pup.h5", "--format", "npy"}), HasSubstr("--out"));
  EXPECT_THAT(refused(2, {"pup.h5", "--format", "gcal", "--out", "o.h5"}),
              HasSubstr("does not hold temperature"));
  EXPECT_THAT(refused(2, {"pup.h5", "--format", "npy", "--field", "tbb", "--out", "o.npy"}),
              HasSubstr("it holds pup/"));
  EXPECT_THAT(refused(2, {"pup.h5", "--format", "npy", "--sheet", "--out", "o.npy"}),
              HasSubstr("no sheet"));
  EXPECT_THAT(refused(2, {"all.h5", "--format", "npy", "--pup", "3", "--out", "o.npy"}),
              HasSubstr("0 to 2"));
  EXPECT_THAT(refused(2, {"all.h5", "--format", "npy", "--out", "o-%d.npy"}), HasSubstr("--pup"));
  EXPECT_THAT(refused(2, {"all.h5", "--format", "vtk", "--out", "o.vtp"}), HasSubstr("%05d"));
  EXPECT_THAT(refused(2, {"all.h5", "--format", "gcal", "--scale", "1,0", "--out", "o.h5"}),
              HasSubstr("MIN below MAX"));
  EXPECT_THAT(refused(2, {"all.h5", "--format", "npy", "--scale", "0,1", "--out", "o.npy"}),
              HasSubstr("gcal"));
  EXPECT_THAT(refused(2, {"all.h5", "--format", "gcal", "--field", "touched", "--out", "o.h5"}),
              HasSubstr("--scale"));
  ASSERT_EQ(record("empty.h5", {"--record-from", "100"}).code, 0);
  EXPECT_THAT(refused(2, {"empty.h5", "--format", "npy", "--out", "o.npy"}), HasSubstr("no frame"));
  scratch_.file("mine.npy", "mine");
  EXPECT_THAT(refused(4, {"pup.h5", "--format", "npy", "--out", "mine.npy"}), HasSubstr("--force"));
  EXPECT_EQ(test::contents(scratch_.path("mine.npy")), "mine");
  EXPECT_EQ(scratch_.entries(), 5);
}

TEST_F(CliExport, CentresStandForPointsThatWereNotRecorded) {
  ASSERT_EQ(record("pup.h5", {"--record-from", "20"}).code, 0);
  ASSERT_EQ(pupflow({"export", "pup.h5", "--format", "vtk", "--out", "p.vtp", "--quiet"}).code, 0);
  EXPECT_THAT(test::contents(scratch_.path("p.vtp")), HasSubstr("NumberOfPoints=\"3\""));
}

TEST_F(CliExport, PatternsCarryWhatMadeThem) {
  ASSERT_EQ(record("all.h5", {"--record-fields", "afferent", "--set", "ta=0.7"}).code, 0);
  ASSERT_EQ(pupflow({"export", "all.h5", "--format", "gcal", "--out", "p.h5", "--quiet"}).code, 0);
  const test::Outcome info = pupflow({"info", "p.h5"});
  EXPECT_EQ(info.code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("p.h5: patterns"));
  EXPECT_THAT(info.out, HasSubstr("ta = 0.7"));
  EXPECT_THAT(refused(2, {"p.h5", "--format", "npy", "--out", "o.npy"}),
              HasSubstr("is no recording"));
}

TEST_F(CliExport, HelpNamesEachFormatAndWhoReadsIt) {
  const std::string help = pupflow({"export", "--help"}).out;
  for (const char* word : {"npy", "timedarray", "gcal", "vtk", "Brian2", "ImaGen", "ParaView"}) {
    EXPECT_THAT(help, HasSubstr(word));
  }
}

}  // namespace
}  // namespace pupflow
