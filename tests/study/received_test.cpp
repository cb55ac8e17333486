// Folders of sweeps that come from somebody else: nothing in them is run, and nothing is written
// outside them.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>

#include "tests/study/sweep_program.h"

namespace pupflow::study::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Received : public SweepProgram {
 protected:
  static Words sweep(const Words& more = {}, const std::string& out = "s") {
    Words words = small("sweep", {"--vary", "ta=0,1", "--seeds", "2"});
    words.insert(words.end(), more.begin(), more.end());
    words.push_back("--out=" + out);
    return words;
  }
  /// A script that shows that it was run, in front of `script`.
  static std::string tell_tale(const std::string& script) {
    return "system('touch PWNED')\n" + script;
  }
  /// Whether some command of a file was run.
  bool pwned() const {
    const std::filesystem::recursive_directory_iterator files(scratch_.folder());
    return std::any_of(begin(files), end(files),
                       [](const auto& entry) { return entry.path().filename() == "PWNED"; });
  }
};

TEST_F(Received, AScriptRunsOnlyWhereTheUserNamesIt) {
  expect(0, sweep());
  const std::string script = contents(path("s/sweep.gp"));
  scratch_.file("s/sweep.gp", tell_tale(script));
  for (const char* lost : {"", "sweep.png", "runs.csv"}) {
    if (*lost) std::filesystem::remove(path("s/") + lost);
    const Outcome outcome = pupflow(sweep());
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out,
                HasSubstr("\nno plot: s/sweep.gp was edited, so it is not run by itself; add "
                          "--plot-script s/sweep.gp, or run 'gnuplot sweep.gp' in s\n"));
    EXPECT_FALSE(pwned());
  }
  EXPECT_EQ(contents(path("s/sweep.gp")), tell_tale(script));
  EXPECT_THAT(pupflow(sweep({"--plot-script", "s/sweep.gp"})).out, HasSubstr("figure in s/"));
  EXPECT_TRUE(std::filesystem::exists(path("s/PWNED")));
  EXPECT_TRUE(std::filesystem::exists(path("s/sweep.png")));
}

TEST_F(Received, AScriptFromElsewhereDraws) {
  expect(0, sweep({}, "s"));
  const std::string script = contents(path("s/sweep.gp"));
  scratch_.file("my own.gp", script + "print 'drawn'\n");
  std::filesystem::remove(path("s/sweep.svg"));
  expect(0, sweep({"--plot-script", "my own.gp"}));
  EXPECT_TRUE(std::filesystem::exists(path("s/sweep.svg")));
  EXPECT_EQ(contents(path("s/sweep.gp")), script);
  EXPECT_THAT(expect(4, sweep({"--plot-script", "none.gp"}, "t")),
              HasSubstr("--plot-script none.gp: there is no such file"));
  EXPECT_FALSE(std::filesystem::exists(path("t")));
  scratch_.file("empty.gp", "");
  EXPECT_THAT(expect(4, sweep({"--plot-script", "empty.gp"})),
              HasSubstr("s/sweep.png: the script drew no such picture"));
  scratch_.file("wrong.gp", "plot nothing\n");
  EXPECT_THAT(expect(4, sweep({"--plot-script", "wrong.gp"})),
              HasSubstr("wrong.gp: gnuplot failed with exit code"));
}

TEST_F(Received, IsMergedWithoutAnEditedScript) {
  expect(0, sweep());
  scratch_.file("s/sweep.gp", tell_tale(""));
  expect(0, sweep({"--shard", "1/1"}, "part"));
  const Words merge{"merge", "part", "--out", "s"};
  EXPECT_THAT(pupflow(merge).out, HasSubstr("no plot: s/sweep.gp was edited"));
  EXPECT_FALSE(pwned());
}

TEST_F(Received, SettingsOfGnuplotPlayNoPart) {
  expect(0, sweep());
  const auto files = files_of(path("s"));
  std::filesystem::create_directories(path("home/.config/gnuplot"));
  for (const char* name : {"home/.gnuplot", "home/.config/gnuplot/gnuplotrc", "s/.gnuplot"})
    scratch_.file(name, tell_tale("set terminal dumb\nexit\n"));
  const Outcome outcome =
      pupflow_behind("export HOME='" + path("home") + "' XDG_CONFIG_HOME='" + path("home/.config") +
                         "' GNUTERM=dumb FIT_LOG=fit GNUPLOT_LIB='" + path("home") + "'; exec",
                     sweep());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_FALSE(pwned());
  std::filesystem::remove(path("s/.gnuplot"));
  EXPECT_TRUE(files_of(path("s")) == files);
}

TEST_F(Received, AProgramInTheFolderIsNotGnuplot) {
  expect(0, sweep());
  for (const char* name : {"s/gnuplot", "gnuplot"}) {
    scratch_.file(name, "#!/bin/sh\ntouch PWNED\n");
    std::filesystem::permissions(path(name), std::filesystem::perms::owner_all);
  }
  for (const char* first : {".", "", "s", "../s"})
    EXPECT_EQ(pupflow_behind(std::string("PATH='") + first + "':$PATH exec", sweep()).code, 0);
  EXPECT_FALSE(pwned());
}

TEST_F(Received, FoldersMayHaveAnyName) {
  std::filesystem::create_directories(path("elsewhere/s"));
  for (const std::string folder :
       {"-", "--", "a b", "it's", "$(touch PWNED)", "`touch PWNED`", "~", "s", "\"", "a;b"}) {
    const Outcome outcome =
        pupflow_behind("CDPATH='" + path("elsewhere") + "' exec", sweep({}, folder));
    EXPECT_EQ(outcome.code, 0) << folder << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(path(folder) + "/sweep.png")) << folder;
  }
  EXPECT_TRUE(std::filesystem::is_empty(path("elsewhere/s")));
  EXPECT_FALSE(pwned());
}

TEST_F(Received, LinksAreRefusedInOneLine) {
  expect(0, sweep());
  scratch_.file("victim", "mine");
  for (const std::string name : {"journal.csv", "runs.csv", "summary.csv", "sweep.png", "sweep.svg",
                                 "sweep.gp", "sweep.lock"}) {
    const std::string file = path("s/" + name), aside = path("aside");
    const bool there = std::filesystem::exists(file);
    if (there) std::filesystem::rename(file, aside);
    std::filesystem::create_symlink(path("victim"), file);
    const std::string said = expect(4, sweep());
    EXPECT_THAT(said, HasSubstr("pupflow: s/" + name + ": is a symbolic link"));
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1);
    std::filesystem::remove(file);
    if (there) std::filesystem::rename(aside, file);
  }
  EXPECT_EQ(contents(path("victim")), "mine");
  expect(0, sweep());
}

TEST_F(Received, PipesDoNotHoldItUp) {
  expect(0, sweep());
  for (const std::string name : {"journal.csv", "runs.csv", "sweep.gp", "manifest.toml"}) {
    std::filesystem::remove(path("s/" + name));
    ASSERT_EQ(::mkfifo(path("s/" + name).c_str(), 0600), 0);
    EXPECT_THAT(expect(4, sweep()), HasSubstr("s/" + name + ": is no regular file"));
    std::filesystem::remove(path("s/" + name));
    expect(0, sweep({"--force"}));
  }
}

TEST_F(Received, ControlCharactersDoNotReachTheTerminal) {
  expect(0, sweep());
  const std::string whole = contents(path("s/runs.csv"));
  std::string runs = whole;
  runs.replace(runs.find(",fine,"), 6, ",fine; \x1b]0;mine\x07,");
  scratch_.file("s/runs.csv", runs);
  EXPECT_THAT(expect(2, sweep()), HasSubstr("this row is damaged"));
  scratch_.file("s/runs.csv", whole);
  std::string summary = contents(path("s/summary.csv"));
  summary.insert(summary.find("\nta,") + 1, "\x1b[2J");
  scratch_.file("odd.csv", summary);
  const Outcome outcome = pupflow({"compare", "odd.csv", "odd.csv"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("[2Jta"), Not(HasSubstr("\x1b"))));
  std::string manifest = contents(path("s/manifest.toml"));
  manifest.replace(manifest.find("\"sweep\""), 7, "\"\\u001b[2J\"");
  scratch_.file("s/manifest.toml", manifest);
  for (const Words& words : {sweep(), Words{"merge", "s", "--out", "t"}, Words{"info", "s"}})
    EXPECT_THAT(expect(2, words), Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace pupflow::study::test
