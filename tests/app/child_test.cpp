#include "app/io/child.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "app/io/machine.h"
#include "tests/app/failing.h"
#include "tests/support/scratch.h"

namespace pupflow::io {
namespace {

using pupflow::test::failure_of;
using pupflow::test::Scratch;
using ::testing::HasSubstr;
using ::testing::Not;

class AChild : public ::testing::Test {
 protected:
  ChildEnd shell(const std::string& text) const {
    return run_child({"/bin/sh", {"-c", text}, scratch_.folder().string(), {"PATH=/usr/bin:/bin"}});
  }
  const Scratch scratch_;
};

TEST_F(AChild, RunsInItsFolderWithItsEnvironment) {
  EXPECT_EQ(shell("pwd").last_words, std::filesystem::canonical(scratch_.folder()).string() + "\n");
  ::setenv("PUPFLOW_MARK", "1", 1);
  EXPECT_THAT(shell("env").last_words, Not(HasSubstr("PUPFLOW_MARK")));
  ::unsetenv("PUPFLOW_MARK");
}

TEST_F(AChild, TellsHowItEnded) {
  EXPECT_EQ(shell("exit 3").status, 3);
  EXPECT_EQ(shell("kill -9 $$").status, 128 + SIGKILL);
  EXPECT_EQ(shell("echo out; echo error >&2").last_words, "out\nerror\n");
}

TEST_F(AChild, ReadsNothingAndGetsNoOpenFile) {
  EXPECT_EQ(shell("cat").last_words, "");
  const int open = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  EXPECT_EQ(shell("test -e /proc/$$/fd/" + std::to_string(open) + " || echo closed").last_words,
            "closed\n");
  ::close(open);
}

TEST_F(AChild, MayPrintALotAndCloseItsStreams) {
  const std::string words = shell("yes | head -c 1000000; echo end").last_words;
  EXPECT_LE(words.size(), std::size_t{1} << 16);
  EXPECT_TRUE(words.ends_with("end\n"));
  EXPECT_EQ(shell("exec >&- 2>&-; sleep 0.1; exit 5").status, 5);
}

TEST_F(AChild, TakesWhatItIsFed) {
  FedChild counting({"/bin/sh", {"-c", "wc -c; echo done >&2"}, "/", {"PATH=/usr/bin:/bin"}});
  const std::string megabyte(std::size_t{1} << 20, 'x');
  EXPECT_TRUE(counting.feed(megabyte));
  EXPECT_TRUE(counting.feed("end"));
  const ChildEnd end = counting.finish();
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.last_words, "1048579\ndone\n");
}

TEST_F(AChild, MayPrintMoreThanAPipeHoldsWhileItIsFed) {
  FedChild echo({"/bin/cat", {}, "/", {}});
  EXPECT_TRUE(echo.feed(std::string(std::size_t{1} << 22, 'x') + "end"));
  const ChildEnd end = echo.finish();
  EXPECT_EQ(end.last_words.size(), std::size_t{1} << 16);
  EXPECT_TRUE(end.last_words.ends_with("end"));
}

TEST_F(AChild, ThatEndsBeforeItTookAllSaysWhy) {
  FedChild failing({"/bin/sh",
                    {"-c", "head -c 10 >/dev/null; echo full >&2; exit 7"},
                    "/",
                    {"PATH=/usr/bin:/bin"}});
  EXPECT_FALSE(failing.feed(std::string(std::size_t{1} << 22, 'x')));
  const ChildEnd end = failing.finish();
  EXPECT_EQ(end.status, 7);
  EXPECT_EQ(end.last_words, "full\n");
}

TEST_F(AChild, ThatIsFedEndsWithItsObject) {
  const std::string mark = scratch_.path("mark");
  {
    FedChild waiting(
        {"/bin/sh", {"-c", "cat >/dev/null; touch " + mark}, "/", {"PATH=/usr/bin:/bin"}});
    EXPECT_TRUE(waiting.feed("x"));
  }
  EXPECT_FALSE(std::filesystem::exists(mark));
}

TEST_F(AChild, ThatDoesNotStartIsNamed) {
  const auto start = [&](const std::string& program, const std::string& folder) {
    return failure_of(ExitCode::bad_file, [&] { run_child({program, {}, folder, {}}); });
  };
  EXPECT_THAT(start(scratch_.path("none"), "/"), HasSubstr("none: cannot start: No such file"));
  EXPECT_THAT(start("/bin/sh", scratch_.path("nowhere")), HasSubstr("/bin/sh: cannot start"));
}

TEST_F(AChild, IsFoundInFoldersNamedFromTheRootOnly) {
  const std::string before = std::getenv("PATH");
  std::filesystem::create_directory(scratch_.path("bin"));
  std::filesystem::permissions(scratch_.file("bin/tool", "#!/bin/sh\n"),
                               std::filesystem::perms::owner_all);
  const std::string relative = std::filesystem::relative(scratch_.path("bin")).string();
  ::setenv("PATH", (":.:" + relative).c_str(), 1);
  EXPECT_EQ(program_path("tool"), "");
  ::setenv("PATH", (relative + ":" + scratch_.path("bin")).c_str(), 1);
  EXPECT_EQ(program_path("tool"), scratch_.path("bin/tool"));
  ::setenv("PATH", before.c_str(), 1);
}

}  // namespace
}  // namespace pupflow::io
