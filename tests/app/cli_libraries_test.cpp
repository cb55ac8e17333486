// Which shared libraries the program loads while it works, by the word of the dynamic loader. What
// draws nothing must touch no graphics library, not even late.
#include <gmock/gmock.h>

#include "program.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

class CliLibraries : public testing::Test {
 protected:
  /// A copy of the program with a graphics module beside it, for what finds one and loads it.
  CliLibraries() {
    fs::copy_file(PUPFLOW_PROGRAM, scratch_.path("pupflow"));
    fs::copy_file(PUPFLOW_FAKE_GRAPHICS, scratch_.path("libpupflow_graphics.so"));
  }

  /// Lines of the loader's log about files that `pupflow ARGUMENTS` loaded; children, such as a
  /// plotting program, keep logs of their own.
  std::vector<std::string> loaded(const std::string& arguments) const {
    const test::Outcome outcome = test::run_program(
        "/bin/sh",
        {"-c", "echo $$ > pid; export LD_DEBUG=files LD_DEBUG_OUTPUT=loader; exec ./pupflow " +
                   arguments},
        scratch_.folder().string());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::string pid = test::contents(scratch_.path("pid"));
    pid.erase(pid.find_last_not_of('\n') + 1);
    std::istringstream log(test::contents(scratch_.path("loader." + pid)));
    std::vector<std::string> files;
    for (std::string line; std::getline(log, line);) {
      if (line.find("generating link map") != std::string::npos) files.push_back(line);
    }
    return files;
  }

  test::Scratch scratch_;
};

const auto kOfGraphics =
    AnyOf(HasSubstr("pupflow_graphics"), HasSubstr("libGL"), HasSubstr("libEGL"),
          HasSubstr("libOpenGL"), HasSubstr("libglfw"), HasSubstr("libX11"), HasSubstr("wayland"));

TEST_F(CliLibraries, TheLogShowsAModuleThatIsLoadedLate) {
  const auto files = loaded("render --steps 1");
  EXPECT_THAT(files, Contains(HasSubstr("libpupflow_graphics.so")));
  EXPECT_THAT(files, Contains(HasSubstr("libc.so")));
}

TEST_F(CliLibraries, WorkWithoutPicturesLoadsNoGraphicsLibrary) {
  const std::vector<std::string> calls{
      "run cold --steps 5 --csv m.csv --pups p.csv",
      "sweep --vary ta=0.2,0.8 --seeds 2 --steps 5 --set discard=0 --out s --quiet",
      "figure2 --steps 2 --set discard=0 --seeds 2 --out f --quiet",
      "explain --after 1 --quiet",
      "params",
  };
  for (const std::string& call : calls) {
    const auto files = loaded(call);
    EXPECT_THAT(files, Contains(HasSubstr("libc.so"))) << call;
    EXPECT_THAT(files, Each(Not(kOfGraphics))) << call;
  }
}

}  // namespace
}  // namespace pupflow
