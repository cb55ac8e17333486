// pupflow info on files of every kind.
#include <gmock/gmock.h>

#include "program.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class CliInfo : public testing::Test {
 protected:
  test::Outcome pupflow(const std::vector<std::string>& arguments) const {
    return test::run_program(PUPFLOW_PROGRAM, arguments, scratch_.folder().string());
  }
  std::string info(const std::string& path, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> call{"info", path};
    call.insert(call.end(), more.begin(), more.end());
    const test::Outcome outcome = pupflow(call);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  }
  test::Scratch scratch_;
};

TEST_F(CliInfo, TellsWhatARunWrote) {
  ASSERT_EQ(
      pupflow({"run", "--set", "pups=3", "--set", "face_points=2", "--steps", "20", "--csv",
               "m.csv", "--pups", "p.csv", "--record", "r.h5", "--checkpoint", "c.h5", "--quiet"})
          .code,
      0);
  const std::string changed = "pups = 3, face_points = 2, steps = 20; all others";
  EXPECT_THAT(info("r.h5"),
              AllOf(HasSubstr("recording"), HasSubstr(changed), ContainsRegex("frames +2\n"),
                    HasSubstr("10 to 20"), ContainsRegex("pup/turn +2 x 3 +f8 +rad/s +How fast")));
  EXPECT_THAT(info("c.h5"), AllOf(HasSubstr("checkpoint"), HasSubstr(changed),
                                  ContainsRegex("step +20\n"), HasSubstr("position")));
  EXPECT_THAT(info("m.csv"), AllOf(HasSubstr("metrics CSV"), ContainsRegex("rows +20\n"),
                                   ContainsRegex("flow +20 +text +1/s")));
  EXPECT_THAT(info("p.csv"), AllOf(HasSubstr("pups CSV"), ContainsRegex("rows +60\n"),
                                   ContainsRegex("heading +60 +text +rad")));
  EXPECT_THAT(info("r.h5", {"--json"}),
              AllOf(HasSubstr("\"pups\": 3,"), HasSubstr("\"contact\": \"nearest\""),
                    HasSubstr("\"shape\": [2, 3]")));
}

TEST_F(CliInfo, TellsWhyARunEndedEarly) {
  scratch_.file("m.csv",
                "# Software = pupflow 0.2.0\nstep,time,mean_tb\n1,0.01,0.6\n"
                "# ended early: interrupted after step 1\n");
  EXPECT_THAT(info("m.csv"), ContainsRegex("ended early +interrupted after step 1\n"));
}

TEST_F(CliInfo, TellsOfASweepByItsFolderOrManifest) {
  ASSERT_EQ(pupflow({"sweep", "--vary", "ta=0.2,0.8", "--seeds", "2", "--set", "pups=2", "--set",
                     "face_points=2", "--steps", "600", "--out", "s", "--quiet"})
                .code,
            0);
  for (const char* path : {"s", "s/manifest.toml"}) {
    EXPECT_THAT(info(path), AllOf(HasSubstr("sweep"), HasSubstr("ta over 2 values, 0.2 to 0.8"),
                                  ContainsRegex("runs +4\n"), ContainsRegex("finished +yes")));
  }
  EXPECT_THAT(info("s/runs.csv"), HasSubstr("runs CSV of a sweep"));
  EXPECT_THAT(info("s/summary.csv"), HasSubstr("summary CSV of a sweep"));
}

TEST_F(CliInfo, TellsOfAScene) {
  scratch_.file("s.toml", "title = \"Warm\"\nta = 0.8\n");
  EXPECT_THAT(info("s.toml"), AllOf(HasSubstr("scene"), HasSubstr("Warm"), HasSubstr("ta = 0.8;")));
}

TEST_F(CliInfo, OldFilesAndOthers) {
  const test::Outcome old = pupflow({"info", std::string(PUPFLOW_OLD_FILES) + "/recording.h5"});
  EXPECT_EQ(old.code, 0);
  EXPECT_THAT(old.out, HasSubstr("body_temperature"));
  EXPECT_THAT(old.err, HasSubstr("older version"));
  EXPECT_THAT(pupflow({"info", std::string(PUPFLOW_OLD_FILES) + "/figure1.png"}).out,
              AllOf(HasSubstr("picture"), HasSubstr("pixels")));
  const test::Outcome text = pupflow({"info", scratch_.file("t.txt", "hello\n")});
  EXPECT_EQ(text.code, 2);
  EXPECT_THAT(text.err, HasSubstr("does not say that pupflow wrote it"));
  const test::Outcome film = pupflow({"info", scratch_.file("film.mp4", "moving\n")});
  EXPECT_EQ(film.code, 2);
  EXPECT_THAT(film.err, AllOf(HasSubstr("apt install ffmpeg"), HasSubstr("film.mp4 > recipe.txt")));
  EXPECT_EQ(pupflow({"info", "none.png"}).code, 4);
  EXPECT_EQ(pupflow({"info", "."}).code, 2);
  EXPECT_EQ(pupflow({"info"}).code, 2);
}

TEST_F(CliInfo, PrintsNoControlCharactersOfAFile) {
  scratch_.file("m.csv",
                "# Software = pupflow 0.2.0\n# picture = a\x1b[31m\nstep,time,\x1b[2J\n1,0.01,0\n");
  EXPECT_THAT(info("m.csv"), Not(HasSubstr("\x1b")));
  EXPECT_THAT(info("m.csv", {"--json"}), Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace pupflow
