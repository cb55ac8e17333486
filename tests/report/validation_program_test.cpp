// pupflow report validation, from the command line to the files.
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "app/io/csv.h"
#include "app/io/png.h"
#include "tests/app/program.h"
#include "tests/support/scratch.h"

namespace pupflow::report {
namespace {

using pupflow::test::contents;
using pupflow::test::Outcome;
using pupflow::test::Scratch;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;

constexpr const char* kFiles[] = {"readings", "window",  "window_long",  "wall",
                                  "flow",     "overlap", "units",        "heat",
                                  "partings", "mirror",  "readings_body"};
constexpr const char* kPictures[] = {"readings", "window", "flow", "readings_body"};

TEST(ValidationProgram, WritesAPageWithEveryTableItsFiguresAndNumbers) {
  const Scratch scratch;
  const Outcome outcome = pupflow::test::run_program(
      PUPFLOW_PROGRAM, {"report", "validation", "--quick", "--threads", "2", "--out", "r"},
      scratch.folder().string());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "report in r/report.md\n");
  const std::string page = contents(scratch.path("r/report.md"));
  for (const char* heading :
       {"## The three contact readings", "## The paper's window", "## Positions in long runs",
        "## Pup flow over several lags", "## Interpenetration", "## Another unit of length",
        "## Heat balance", "## Pup numbers and mirrors", "## The three readings with"}) {
    EXPECT_THAT(page, HasSubstr(heading));
  }
  for (const std::string file : kFiles) {
    EXPECT_THAT(io::read_csv_header(scratch.path("r/" + file + ".csv")),
                Contains(Pair("command", "pupflow report validation --quick")))
        << file;
  }
  for (const std::string picture : kPictures) {
    EXPECT_THAT(page, HasSubstr("](" + picture + ".png)"));
    EXPECT_GT(io::read_png(scratch.path("r/" + picture + ".png")).width, 500);
  }
}

TEST(ValidationProgram, KeepsFinishedSectionsWhenInterrupted) {
  const Scratch scratch;
  pupflow::test::Running running(PUPFLOW_PROGRAM, {"report", "validation", "--quick", "--out", "r"},
                                 scratch.folder().string());
  while (!std::filesystem::exists(scratch.path("r/readings.png"))) ::usleep(20000);
  running.signal(SIGINT);
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
  EXPECT_TRUE(std::filesystem::exists(scratch.path("r/readings.csv")));
  EXPECT_FALSE(std::filesystem::exists(scratch.path("r/report.md")));
}

}  // namespace
}  // namespace pupflow::report
