// pupflow report, from the command line to the files.
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <regex>

#include "app/io/csv.h"
#include "app/io/png.h"
#include "tests/app/program.h"
#include "tests/support/scratch.h"

namespace pupflow::report {
namespace {

using pupflow::test::contents;
using pupflow::test::Outcome;
using pupflow::test::Running;
using pupflow::test::Scratch;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Key;
using ::testing::Pair;

Outcome pupflow(const Scratch& scratch, const std::vector<std::string>& words) {
  return pupflow::test::run_program(PUPFLOW_PROGRAM, words, scratch.folder().string());
}

/// Files that a page shows.
std::vector<std::string> pictures_of(const std::string& page) {
  static const std::regex picture(R"(!\[[^\]]+\]\(([^)]+)\))");
  std::vector<std::string> names;
  for (std::sregex_iterator i(page.begin(), page.end(), picture), end; i != end; ++i) {
    names.push_back((*i)[1]);
  }
  return names;
}

TEST(ReportProgram, WritesAPageWithItsFiguresAndNumbers) {
  const Scratch scratch;
  const Outcome outcome = pupflow(scratch, {"report", "error", "--quick", "--out", "r"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "report in r/report.md\n");
  const std::string page = contents(scratch.path("r/report.md"));
  EXPECT_THAT(page,
              AllOf(HasSubstr("`pupflow report error --quick`"), HasSubstr("processor"),
                    HasSubstr("compiler"), HasSubstr("**default**"), HasSubstr("What this means"),
                    HasSubstr("Parts of a step that a scene leaves out")));
  for (const char* heading :
       {"## 1. ", "## 2. ", "## 3. ", "## 4. ", "## 5. ", "## 6. ", "## 7. ", "## 8. "}) {
    EXPECT_THAT(page, HasSubstr(heading));
  }
  const std::vector<std::string> pictures = pictures_of(page);
  EXPECT_EQ(pictures.size(), 14u);
  for (const std::string& picture : pictures) {
    const io::Image image = io::read_png(scratch.path("r/" + picture));
    EXPECT_GT(image.width, 500);
    const std::string name = picture.substr(0, picture.rfind('.'));
    EXPECT_TRUE(std::filesystem::exists(scratch.path("r/" + name + ".svg"))) << name;
    EXPECT_THAT(io::read_csv_header(scratch.path("r/" + name + ".csv")),
                AllOf(Contains(Pair("command", "pupflow report error --quick")),
                      Contains(Key("Software")), Contains(Key("alpha"))));
  }
}

TEST(ReportProgram, RefusesAFolderThatHoldsSomething) {
  const Scratch scratch;
  std::filesystem::create_directory(scratch.path("r"));
  scratch.file("r/mine.txt", "text");
  const Outcome outcome = pupflow(scratch, {"report", "error", "--quick", "--out", "r"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("r: holds files already"), HasSubstr("--force")));
  EXPECT_EQ(contents(scratch.path("r/mine.txt")), "text");
}

TEST(ReportProgram, SaysWhichReportsThereAre) {
  const Scratch scratch;
  EXPECT_EQ(pupflow(scratch, {"report"}).code, 2);
  const Outcome outcome = pupflow(scratch, {"report", "eror"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'error'?"));
  EXPECT_EQ(pupflow(scratch, {"report", "error", "--threads", "0"}).code, 2);
  EXPECT_EQ(pupflow(scratch, {"report", "error", "--observable", "flow"}).code, 2);
  EXPECT_EQ(pupflow(scratch, {"report", "stability", "cold"}).code, 2);
}

TEST(ReportProgram, KeepsFinishedScenesWhenInterrupted) {
  const Scratch scratch;
  Running running(PUPFLOW_PROGRAM, {"report", "error", "--out", "r"}, scratch.folder().string());
  while (!std::filesystem::exists(scratch.path("r/fall.png"))) ::usleep(20000);
  running.signal(SIGINT);
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
  EXPECT_TRUE(std::filesystem::exists(scratch.path("r/fall.csv")));
  EXPECT_FALSE(std::filesystem::exists(scratch.path("r/report.md")));
}

TEST(ReportProgram, DoesWithoutGnuplotAndSaysSo) {
  const Scratch scratch;
  std::filesystem::create_directory(scratch.path("bin"));
  std::filesystem::create_symlink("/bin/sh", scratch.path("bin/sh"));
  const Outcome outcome =
      pupflow::test::run_program("/bin/sh",
                                 {"-c",
                                  "PATH='" + scratch.path("bin") +
                                      "' exec \"$0\" report error cold --set pups=4 --set "
                                      "face_points=4 --steps 80 --set discard=30 "
                                      "--quick --quiet --out r",
                                  PUPFLOW_PROGRAM},
                                 scratch.folder().string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string page = contents(scratch.path("r/report.md"));
  EXPECT_THAT(page, AllOf(HasSubstr("gnuplot is not installed"), HasSubstr("gnuplot-nox"),
                          HasSubstr(", consistent |")));
  EXPECT_TRUE(pictures_of(page).empty());
  EXPECT_TRUE(std::filesystem::exists(scratch.path("r/paired.csv")));
}

}  // namespace
}  // namespace pupflow::report
