#include "app/window/settings.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>

#include "app/io/failure.h"
#include "tests/support/scratch.h"

namespace pupflow::window {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

Settings other_settings() {
  Settings settings;
  settings.width = 801;
  settings.height = 602;
  settings.ui_scale = 1.25;
  settings.theme = Theme::dark;
  settings.quality = view::Quality::fast;
  settings.draw = view::Draw::both;
  settings.colormap = "inferno";
  settings.panels = false;
  settings.pause_minimised = true;
  settings.recent = {"/a/\"b\".toml", "/\u03b1/c d.h5"};
  return settings;
}

/// What is wrong with the text of a file.
std::string refusal(const std::string& text) {
  try {
    parse_settings(text, "s.toml");
  } catch (const io::Failure& failure) {
    EXPECT_EQ(failure.code(), io::ExitCode::bad_file);
    return failure.what();
  }
  return {};
}

TEST(Settings, ReadBackToTheSame) {
  for (const Settings& settings : {Settings{}, other_settings()}) {
    EXPECT_EQ(parse_settings(settings_text(settings), "s.toml"), settings);
  }
}

TEST(Settings, UnknownKeysAreIgnoredAndMissingOnesKeepTheirDefaults) {
  Settings expected;
  expected.theme = Theme::dark;
  EXPECT_EQ(parse_settings("theme = 'dark'\nnew_in_a_later_version = [1, {}]\n", "s.toml"),
            expected);
}

TEST(Settings, SayWhereAFileIsWrongAndWhatWouldBeRight) {
  EXPECT_EQ(refusal("\ntheme = 'drak'"), "s.toml:2:9: theme must be light or dark");
  EXPECT_EQ(refusal("width = 5"), "s.toml:1:9: width must be 16 to 16384");
  EXPECT_EQ(refusal("width = 1e3"), "s.toml:1:9: width must be 16 to 16384");
  EXPECT_EQ(refusal("ui_scale = nan"), "s.toml:1:12: ui_scale must be 0.5 to 4");
  EXPECT_EQ(refusal("panels = 1"), "s.toml:1:10: panels must be true or false");
  EXPECT_THAT(refusal("colormap = 'red'"), HasSubstr("colormap must be viridis or"));
  EXPECT_THAT(refusal("recent = [1]"), HasSubstr("recent must be a list of at most 10 names"));
  EXPECT_THAT(refusal("recent = ['1','2','3','4','5','6','7','8','9','10','11']"),
              HasSubstr("at most 10"));
  EXPECT_THAT(refusal("theme"), StartsWith("s.toml:1:"));
  EXPECT_THAT(refusal(std::string(100, '.') + " = 1"), StartsWith("s.toml:"));
}

TEST(Settings, RememberTheLastFilesOnce) {
  Settings settings;
  for (int i = 0; i < 12; ++i) settings.remember("/" + std::to_string(i));
  settings.remember("/5");
  EXPECT_EQ(settings.recent.size(), kMostRecent);
  EXPECT_EQ(settings.recent.front(), "/5");
  EXPECT_EQ(std::ranges::count(settings.recent, "/5"), 1);
  settings.remember("/bad\xff");
  settings.remember("/new\nline");
  EXPECT_EQ(settings.recent.front(), "/5") << "text cannot name those";
}

TEST(Settings, AreWrittenIntoAFolderThatIsMade) {
  const test::Scratch scratch;
  const std::string path = scratch.path("a/b/settings.toml");
  EXPECT_EQ(write_settings(path, other_settings()), "");
  EXPECT_EQ(write_settings(path, other_settings()), "") << "over the former ones";
  std::string problem;
  EXPECT_EQ(read_settings(path, problem), other_settings());
  EXPECT_EQ(problem, "");
}

TEST(Settings, NoFileIsNoProblem) {
  const test::Scratch scratch;
  std::string problem;
  EXPECT_EQ(read_settings(scratch.path("none"), problem), Settings{});
  EXPECT_EQ(read_settings("", problem), Settings{});
  EXPECT_EQ(problem, "");
}

TEST(Settings, ABrokenFileIsSetAsideWithOneLine) {
  const test::Scratch scratch;
  for (const std::string text : {"theme = 'drak'", "\x01\xff", "= ="}) {
    const std::string path = scratch.file("s.toml", text);
    std::string problem;
    EXPECT_EQ(read_settings(path, problem), Settings{});
    EXPECT_THAT(problem, AllOf(StartsWith(path), EndsWith("it is now " + path + ".broken"),
                               Not(HasSubstr("\n"))));
    EXPECT_FALSE(std::filesystem::exists(path));
    EXPECT_EQ(test::contents(path + ".broken"), text);
  }
  const std::string large = scratch.file("s.toml", std::string(100'000, '#'));
  std::string problem;
  EXPECT_EQ(read_settings(large, problem), Settings{});
  EXPECT_THAT(problem, HasSubstr("too large"));
  const std::string pipe = scratch.path("pipe.toml");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(read_settings(pipe, problem), Settings{});
  EXPECT_THAT(problem, HasSubstr("is no file with settings"));
}

TEST(Settings, WhatCannotBeWrittenIsSaidInOneLine) {
  const test::Scratch scratch;
  scratch.file("file", "");
  const std::string problem = write_settings(scratch.path("file/settings.toml"), Settings{});
  EXPECT_THAT(problem, AllOf(StartsWith("settings are not kept: "), Not(HasSubstr("\n"))));
  EXPECT_THAT(write_settings("", Settings{}), HasSubstr("HOME"));
}

/// One variable of the environment, as long as it lives.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    set(value);
  }
  ~Variable() { set(before_ ? before_->c_str() : nullptr); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  void set(const char* value) const {
    if (value == nullptr) {
      ::unsetenv(name_);
    } else {
      ::setenv(name_, value, 1);
    }
  }
  const char* name_;
  std::optional<std::string> before_;
};

TEST(Settings, LieWhereThePlatformKeepsThem) {
  const Variable home("HOME", "/nowhere");
  {
    const Variable config("XDG_CONFIG_HOME", "/c");
    EXPECT_EQ(settings_path(), "/c/pupflow/settings.toml");
  }
  {
    const Variable config("XDG_CONFIG_HOME", "not/whole");
    EXPECT_EQ(settings_path(), "/nowhere/.config/pupflow/settings.toml");
  }
  const Variable config("XDG_CONFIG_HOME", nullptr);
  EXPECT_EQ(settings_path(), "/nowhere/.config/pupflow/settings.toml");
  const Variable nowhere("HOME", nullptr);
  EXPECT_EQ(settings_path(), "");
}

}  // namespace
}  // namespace pupflow::window
