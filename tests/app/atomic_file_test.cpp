#include "app/io/atomic_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/io/unfinished.h"
#include "failing.h"
#include "tests/support/scratch.h"

namespace pupflow::io {
namespace {

using test::contents;
using test::failure_of;
using testing::HasSubstr;

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
  const test::Scratch scratch;
  AtomicFile file(scratch.path("a.txt"), false);
  file.write("one ");
  file.write("two");
  EXPECT_FALSE(std::filesystem::exists(scratch.path("a.txt")));
  file.commit();
  EXPECT_EQ(contents(scratch.path("a.txt")), "one two");
  EXPECT_EQ(scratch.entries(), 1);
}

TEST(AtomicFile, AbandonedLeavesNothing) {
  const test::Scratch scratch;
  {
    AtomicFile file(scratch.path("a.txt"), false);
    file.write(std::string(1 << 20, 'x'));
    EXPECT_EQ(scratch.entries(), 1);
  }
  EXPECT_EQ(scratch.entries(), 0);
}

TEST(AtomicFile, AbandonedKeepsWhatWasThere) {
  const test::Scratch scratch;
  const std::string path = scratch.file("a.txt", "old");
  {
    AtomicFile file(path, true);
    file.write("new");
  }
  EXPECT_EQ(contents(path), "old");
  EXPECT_EQ(scratch.entries(), 1);
}

TEST(AtomicFile, RefusesWhatExistsWithoutForce) {
  const test::Scratch scratch;
  const std::string path = scratch.file("a.txt", "old");
  const std::string message = failure_of(ExitCode::bad_file, [&] { AtomicFile file(path, false); });
  EXPECT_THAT(message, HasSubstr(path));
  EXPECT_THAT(message, HasSubstr("--force"));
  EXPECT_EQ(contents(path), "old");
}

TEST(AtomicFile, RefusesWhatAppearedMeanwhile) {
  const test::Scratch scratch;
  {
    AtomicFile file(scratch.path("a.txt"), false);
    file.write("mine");
    scratch.file("a.txt", "theirs");
    failure_of(ExitCode::bad_file, [&] { file.commit(); });
  }
  EXPECT_EQ(contents(scratch.path("a.txt")), "theirs");
  EXPECT_EQ(scratch.entries(), 1);
}

TEST(AtomicFile, ForceReplacesAndKeepsPermissions) {
  const test::Scratch scratch;
  const std::string path = scratch.file("a.txt", "old");
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  AtomicFile file(path, true);
  file.write("new");
  file.commit();
  EXPECT_EQ(contents(path), "new");
  struct stat status = {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0640U);
}

TEST(AtomicFile, FollowsALink) {
  const test::Scratch scratch;
  scratch.file("real.txt", "old");
  std::filesystem::create_symlink("real.txt", scratch.path("link.txt"));
  AtomicFile file(scratch.path("link.txt"), true);
  file.write("new");
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(scratch.path("link.txt")));
  EXPECT_EQ(contents(scratch.path("real.txt")), "new");
}

TEST(AtomicFile, RefusesALinkToNothing) {
  const test::Scratch scratch;
  std::filesystem::create_symlink("nothing", scratch.path("link.txt"));
  for (const bool force : {false, true}) {
    EXPECT_THAT(
        failure_of(ExitCode::bad_file, [&] { AtomicFile f(scratch.path("link.txt"), force); }),
        HasSubstr("link.txt: is a link to a file that is not there"));
  }
  EXPECT_EQ(scratch.entries(), 1);
}

TEST(AtomicFile, RefusesANameThatIsTooLongWhileItIsWritten) {
  const test::Scratch scratch;
  const auto of = [&](std::size_t size) { return scratch.path(std::string(size, 'n')); };
  const std::string message =
      failure_of(ExitCode::bad_file, [&] { refuse_existing(of(255), false); });
  EXPECT_THAT(message, HasSubstr("name is too long; a file's may have 223 bytes"));
  failure_of(ExitCode::bad_file, [&] { refuse_existing(of(224), false); });
  AtomicFile longest(of(223), false);
  longest.write("x");
  longest.commit();
  EXPECT_EQ(contents(of(223)), "x");
}

TEST(AtomicFile, SaysInItsNameThatItIsUnfinishedAndWhose) {
  const test::Scratch scratch;
  const std::string name = "a.txt." + std::to_string(::getpid());
  AtomicFile one(scratch.path("a.txt"), false), two(scratch.path("a.txt"), false);
  EXPECT_EQ(one.written_aside(), scratch.path(name + ".unfinished"));
  EXPECT_EQ(two.written_aside(), scratch.path(name + "-1.unfinished"));
}

TEST(AtomicFile, MayBeLeftAside) {
  const test::Scratch scratch;
  std::string aside;
  {
    AtomicFile file(scratch.path("a.txt"), false);
    aside = file.written_aside();
    file.write_at_start("left");
    file.keep();
  }
  EXPECT_EQ(contents(aside), "left");
  EXPECT_EQ(scratch.entries(), 1);
}

TEST(Unfinished, AreNamedWhereNoProcessWritesThem) {
  const test::Scratch scratch;
  const std::string outputs[] = {scratch.path("a.txt"), "", "-"};
  const auto said = [&] {
    testing::internal::CaptureStderr();
    name_unfinished(outputs);
    return testing::internal::GetCapturedStderr();
  };
  const AtomicFile written(scratch.path("a.txt"), false);
  scratch.file("a.txt.x.unfinished", "");  // no name of this program
  scratch.file("unfinished", "");
  EXPECT_EQ(said(), "");
  scratch.file("b.h5.77.unfinished", "");
  scratch.file("a.txt.9-1.unfinished", "");
  EXPECT_EQ(said(),
            "pupflow: note: earlier runs left unfinished: " + scratch.path("a.txt.9-1.unfinished") +
                ", " + scratch.path("b.h5.77.unfinished") +
                " ('pupflow info FILE' tells what is in one)\n");
  for (const char* name : {"c.1.unfinished", "d.1.unfinished"}) scratch.file(name, "");
  EXPECT_THAT(said(), HasSubstr("c.1.unfinished and 1 more ("));
}

TEST(AtomicFile, NamesThePathAndTheReason) {
  const test::Scratch scratch;
  const std::string file = scratch.file("a.txt", "old");
  const std::string below = file + "/b.txt";
  EXPECT_THAT(failure_of(ExitCode::bad_file, [&] { AtomicFile f(below, false); }),
              HasSubstr(below));
  const std::string lost = scratch.path("nowhere/b.txt");
  EXPECT_THAT(failure_of(ExitCode::bad_file, [&] { AtomicFile f(lost, false); }),
              HasSubstr("no folder"));
  EXPECT_THAT(
      failure_of(ExitCode::bad_file, [&] { AtomicFile f(scratch.folder().string(), true); }),
      HasSubstr("is a folder"));
  failure_of(ExitCode::bad_file, [] { AtomicFile f("", false); });
}

TEST(AtomicFile, ReportsAFullDisk) {
  AtomicFile file("/dev/full", false);
  file.write("x");
  EXPECT_THAT(failure_of(ExitCode::bad_file, [&] { file.commit(); }),
              HasSubstr("/dev/full: cannot write: No space left on device"));
  AtomicFile big("/dev/full", false);
  failure_of(ExitCode::bad_file, [&] { big.write(std::string(1 << 20, 'x')); });
}

TEST(AtomicFile, WritesToStreamsDirectly) {
  EXPECT_TRUE(is_stream("-"));
  EXPECT_TRUE(is_stream("/dev/stdout"));
  EXPECT_TRUE(is_stream("/dev/null"));
  EXPECT_FALSE(is_stream("a.txt"));
  EXPECT_TRUE(is_standard_output("-"));
  EXPECT_TRUE(is_standard_output("/dev/fd/1"));
  EXPECT_FALSE(is_standard_output("/dev/stderr"));
  AtomicFile file("/dev/null", false);
  file.write("x");
  file.commit();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace pupflow::io
