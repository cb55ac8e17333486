// The figures: drawn, or not drawn and said so.
#include <gmock/gmock.h>

#include <regex>

#include "app/io/png.h"
#include "pupflow/observer.h"
#include "tests/study/sweep_program.h"

namespace pupflow::study::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::Pair;

class Picture : public SweepProgram {
 protected:
  static Words sweep(const Words& more) {
    Words words{"--seeds", "2", "--out", "s"};
    words.insert(words.end(), more.begin(), more.end());
    return small("sweep", words);
  }

  /// How many pixels of the picture are not white.
  std::ptrdiff_t ink() const {
    const io::Image image = io::read_png(path("s/sweep.png"));
    std::ptrdiff_t found = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) found += image.rgba[i] < 250 ? 1 : 0;
    return found;
  }
};

TEST_F(Picture, OfFigure2CarriesItsManifestInBothFormats) {
  const Words words{"figure2", "--set",      "pups=3",  "--set", "face_points=3", "--steps", "40",
                    "--set",   "discard=20", "--seeds", "2"};
  expect(0, words);
  const std::string manifest = contents(path("figure2/manifest.toml"));
  EXPECT_THAT(manifest, AllOf(HasSubstr("ta=0,0.043478260869565216,"), HasSubstr("runs = 48"),
                              HasSubstr("steps = 40")));
  EXPECT_THAT(io::read_png_text(path("figure2/figure2.png")),
              AllOf(Contains(Pair("manifest", manifest)), Contains(Pair("steps", "40")),
                    Contains(Pair("seed", "1"))));
  const io::Image image = io::read_png(path("figure2/figure2.png"));
  EXPECT_EQ(image.width, 1200);
  const std::string svg = contents(path("figure2/figure2.svg"));
  EXPECT_THAT(svg, AllOf(HasSubstr(manifest), HasSubstr("<svg"), HasSubstr("</svg>")));
}

TEST_F(Picture, IsDrawnOfEveryKindOfSweep) {
  const std::vector<Words> kinds{
      {"--vary", "ta=0:1:3"},
      {"--vary", "ta=0.2,0.4", "--seeds", "1"},
      {"--vary", "heading=course,body"},
      {"--vary", "ta=0.5", "--vary", "beta=0,0.5"},
      {"--vary", "ta=0,0.5,1", "--vary", "beta=0,0.5"},
      {"--vary", "heading=course,body", "--vary", "ta=0:1:12"},
      {"--vary", "ta=0.4,0.6,0.5"},
      {"--vary", "ta=1,0,0.5", "--vary", "v=10000,1"},
      {"--lhs", "9", "--vary", "ta=0:1", "--vary", "pups=2:4"},
      {"--lhs", "9", "--vary", "heading=course,body", "--vary", "ta=0:1"},
      {"--vary", "ta=0,1", "--set", "k1=0", "--set", "tp=7"},
      {"--vary", "ta=0,1", "--set", "pups=0"}};
  for (Words kind : kinds) {
    const bool seeds = kind.size() > 3 && kind[2] == "--seeds";
    Words words = small("sweep", {"--out", "s", "--force"});
    if (!seeds) words.insert(words.end(), {"--seeds", "2"});
    words.insert(words.end(), kind.begin(), kind.end());
    const Outcome outcome = pupflow(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(std::regex_replace(outcome.err, std::regex("sweep: runs: .* left\n"), ""), "");
    EXPECT_THAT(outcome.out, HasSubstr("figure in s/sweep.png"));
    EXPECT_GT(ink(), 5000);
  }
}

TEST_F(Picture, IsNotDrawnOfMoreThanTwoParametersAndThatIsSaid) {
  const Outcome outcome =
      pupflow(sweep({"--vary", "ta=0,1", "--vary", "beta=0,0.5", "--vary", "heading=course,body"}));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("no plot: 3 parameters take several values"));
  EXPECT_THAT(names_of(path("s")), ElementsAre("manifest.toml", "runs.csv", "summary.csv"));
}

TEST_F(Picture, NeedsGnuplotAndSaysWhatToInstall) {
  std::filesystem::create_directory(path("bin"));
  std::filesystem::create_symlink("/bin/sh", path("bin/sh"));
  for (const std::string& folder : {path("bin"), path("nowhere")}) {
    const Outcome outcome =
        pupflow_behind("PATH='" + folder + "' exec", sweep({"--vary", "ta=0,1"}));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out,
                AllOf(HasSubstr("gnuplot is not installed"), HasSubstr("gnuplot-nox")));
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(names_of(path("s")),
                ElementsAre("manifest.toml", "runs.csv", "summary.csv", "sweep.gp"));
  }
  // Installed meanwhile: the same command draws.
  EXPECT_THAT(pupflow(sweep({"--vary", "ta=0,1"})).out, HasSubstr("figure in"));
  EXPECT_GT(ink(), 5000);
}

TEST_F(Picture, ThatGnuplotFailsToDrawDoesNotAppear) {
  std::filesystem::create_directory(path("bin"));
  scratch_.file("bin/gnuplot",
                "#!/bin/sh\necho half >.pupflow-$$.png\necho 'no fonts' >&2\nexit 3\n");
  std::filesystem::permissions(path("bin/gnuplot"), std::filesystem::perms::owner_all);
  const Outcome outcome =
      pupflow_behind("PATH='" + path("bin") + "':$PATH exec", sweep({"--vary", "ta=0,1"}));
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("exit code 3"), HasSubstr("no fonts"),
                                 HasSubstr("CSV files are complete")));
  EXPECT_FALSE(std::filesystem::exists(path("s/sweep.png")));
  EXPECT_TRUE(std::filesystem::exists(path("s/summary.csv")));
}

TEST_F(Picture, IsDrawnByTheScriptThatTheUserEditedAndNames) {
  const Words words = sweep({"--vary", "ta=0,1"});
  expect(0, words);
  const std::string script = contents(path("s/sweep.gp")), before = contents(path("s/sweep.svg"));
  const std::string label(run_statistics()[statistic_of(Observable::huddling)].label);
  const std::size_t at = script.find(label);
  ASSERT_NE(at, std::string::npos);
  std::string edited = script;
  edited.replace(at, label.size(), "edited by hand");
  scratch_.file("s/sweep.gp", edited);
  expect(0, sweep({"--vary", "ta=0,1", "--plot-script", "s/sweep.gp"}));
  EXPECT_EQ(contents(path("s/sweep.gp")), edited);
  EXPECT_THAT(contents(path("s/sweep.svg")), AllOf(Not(before), HasSubstr("edited by hand")));
}

TEST_F(Picture, ScriptDrawsOnItsOwn) {
  expect(0, sweep({"--vary", "ta=0,1"}));
  for (const char* name : {"sweep.png", "sweep.svg"})
    std::filesystem::remove(path("s") + "/" + name);
  const Outcome outcome =
      pupflow::test::run_program("/usr/bin/env", {"gnuplot", "sweep.gp"}, path("s"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_GT(ink(), 5000);
}

}  // namespace
}  // namespace pupflow::study::test
