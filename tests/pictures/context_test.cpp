#include <gmock/gmock.h>

#include <cstdlib>
#include <iostream>

#include "app/context/glfw_window.h"
#include "app/context/headless.h"
#include "app/io/failure.h"
#include "app/pictures/figure1.h"
#include "tests/pictures/as_program.h"
#include "tests/support/scratch.h"

namespace pupflow::context {
namespace {

using test::run_as_program;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Context, HeadlessReportsWhatItChose) {
  ContextReport report;
  const auto context = make_headless(report);
  EXPECT_TRUE(report.works);
  EXPECT_EQ(report.chosen, context->name());
  EXPECT_NE(report.renderer, "");
  EXPECT_NE(report.version, "");
  EXPECT_EQ(report.tried.back(), report.chosen + ": works");
}

TEST(Context, ProbingLeavesRoomForTheNext) {
  const ContextReport first = probe_headless(), second = probe_headless();
  EXPECT_TRUE(first.works);
  EXPECT_EQ(first.chosen, second.chosen);
  EXPECT_EQ(first.tried, second.tried);
}

TEST(Context, TheEndOfOneLeavesTheOthers) {
  ContextReport report;
  const auto stays = make_headless(report);
  make_headless(report).reset();
  EXPECT_NO_THROW(stays->make_current());
  const std::string all = report.renderer;
  make_headless(report)->release_current();
  EXPECT_NO_THROW(stays->make_current());
  EXPECT_EQ(report.renderer, all);
}

class NoContext : public ::testing::Test {
 protected:
  // The children start afresh: EGL looks at its environment once in a process.
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }

  static void take_drivers_away() {
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
  }
};

TEST_F(NoContext, SaysWhatWasTriedAndWhatToInstall) {
  EXPECT_EXIT(run_as_program([] {
                take_drivers_away();
                ContextReport report;
                make_headless(report);
              }),
              ::testing::ExitedWithCode(5),
              AllOf(HasSubstr("EGL surfaceless"), HasSubstr("EGL default display"),
                    HasSubstr("libegl1"), HasSubstr("libgl1-mesa-dri")));
}

TEST_F(NoContext, ProbingTellsInsteadOfFailing) {
  EXPECT_EXIT(run_as_program([] {
                take_drivers_away();
                const ContextReport report = probe_headless();
                for (const auto& line : report.tried) std::cerr << line << ' ';
                std::_Exit(report.works ? 1 : 0);
              }),
              ::testing::ExitedWithCode(0), HasSubstr("EGL surfaceless"));
}

TEST_F(NoContext, LeavesNoFigure) {
  const test::Scratch folder;
  EXPECT_EXIT(run_as_program([&] {
                take_drivers_away();
                pictures::Figure1Job job;
                job.params.steps = 1;
                job.output = {folder.path("figure.png"), false, true};
                pictures::figure1(job);
              }),
              ::testing::ExitedWithCode(5), "");
  EXPECT_EQ(folder.entries(), 0);
}

TEST_F(NoContext, AWindowWithoutADisplayFailsInOneLine) {
  EXPECT_EXIT(run_as_program([] {
                take_drivers_away();
                GlfwWindow window({});
              }),
              ::testing::ExitedWithCode(5),
              AllOf(HasSubstr("no display is here; "), HasSubstr("DISPLAY"),
                    HasSubstr("OpenGL 3.3"), Not(HasSubstr("GLFW"))));
}

TEST_F(NoContext, ADisplayThatDoesNotAnswerIsNamed) {
  EXPECT_EXIT(run_as_program([] {
                take_drivers_away();
                setenv("DISPLAY", ":7777", 1);
                GlfwWindow window({});
              }),
              ::testing::ExitedWithCode(5),
              AllOf(HasSubstr("display ':7777' does not answer; "), Not(HasSubstr("GLFW"))));
}

}  // namespace
}  // namespace pupflow::context
