// The real executable before files, limits and places that would make it crash or hang: each ends
// with a promised code and one line.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/app/program.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

using test::Outcome;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using Words = std::vector<std::string>;

constexpr const char* kShaders[] = {"spheres.vert", "spheres.frag", "plane.vert",   "plane.frag",
                                    "wall.vert",    "wall.frag",    "resolve.vert", "resolve.frag"};

class Hostile : public testing::Test {
 protected:
  Outcome pupflow(const Words& words) const {
    return test::run_program(PUPFLOW_PROGRAM, words, scratch_.folder().string());
  }

  /// The same, behind some words of a shell: "ulimit -v 400000; exec".
  Outcome pupflow_behind(const std::string& shell, const Words& words) const {
    Words all{"-c", shell + " \"$0\" \"$@\"", PUPFLOW_PROGRAM};
    all.insert(all.end(), words.begin(), words.end());
    return test::run_program("/bin/sh", all, scratch_.folder().string());
  }

  /// What a run that must end with `code` and one line says.
  static std::string line(int code, const Outcome& outcome) {
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_THAT(outcome.err, StartsWith("pupflow: "));
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    return outcome.err;
  }

  std::string refused(int code, const Words& words) const { return line(code, pupflow(words)); }

  const test::Scratch scratch_;
};

TEST_F(Hostile, KeysOfManyPartsAreRefused) {
  std::string key = "a";
  for (int i = 1; i < 40'000; ++i) key += ".a";
  for (const std::string& text :
       {key + " = 1\n", "[" + key + "]\n", "[[" + key + "]]\n", "ta = { " + key + " = 1 }\n",
        "ta = [\n  { " + key + " = 1 }]\n"}) {
    scratch_.file("scene.toml", "pups = 2\n" + text);
    EXPECT_THAT(refused(2, {"run", "scene.toml"}), HasSubstr("more than 32 parts"));
    std::filesystem::create_directory(scratch_.path("shard"));
    scratch_.file("shard/manifest.toml", text);
    refused(2, {"merge", "shard", "--out", "s"});
  }
}

TEST_F(Hostile, NestedValuesAreRefused) {
  for (const std::string part : {"[", "{a=", "{a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a=["}) {
    std::string text = "ta = ";
    for (int i = 0; i < 100'000; ++i) text += part;
    scratch_.file("scene.toml", text.substr(0, 1'000'000));
    EXPECT_THAT(refused(2, {"run", "scene.toml"}), HasSubstr("scene.toml:1:"));
  }
}

TEST_F(Hostile, OfManyProblemsTheFirstAreTold) {
  std::string text;
  for (int i = 0; i < 50'000; ++i) text += "a" + std::to_string(i) + " = 1\n";
  scratch_.file("scene.toml", text);
  const Outcome outcome = pupflow({"run", "scene.toml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 21);
  EXPECT_THAT(outcome.err, HasSubstr("and 49980 lines like these"));
}

TEST_F(Hostile, APngWithAHugeChunkTakesNoMemory) {
  const std::string head("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\2\0\0\0\x90wS\xde", 33);
  scratch_.file("cut.png", head + "\x7f\xff\xff\xfftEXtSoftware");
  scratch_.file("long.png", head + std::string("\1\0\0\1tEXt", 8) + std::string(0x1000005, 'a'));
  for (const char* name : {"cut.png", "long.png"}) {
    EXPECT_THAT(line(4, pupflow_behind("ulimit -v 600000; exec", {"run", "--like", name})),
                HasSubstr("cannot read PNG: "));
  }
  EXPECT_THAT(refused(4, {"info", "long.png"}), HasSubstr("tEXt chunk has 16777217 bytes"));
}

TEST_F(Hostile, EndlessFilesAreReadUpToABound) {
  std::filesystem::create_symlink("/dev/zero", scratch_.path("zero.toml"));
  EXPECT_THAT(refused(4, {"run", "zero.toml"}), HasSubstr("larger than"));
  for (const char* file : kShaders) {
    std::filesystem::create_symlink("/dev/zero", scratch_.path(file));
  }
  EXPECT_THAT(refused(4, {"render", "--shader-dir", ".", "--set", "pups=1", "--steps", "0"}),
              HasSubstr("larger than"));
}

TEST_F(Hostile, FoldersAndPipesThatCannotBeRead) {
  std::filesystem::create_directory(scratch_.path("folder.toml"));
  ::mkfifo(scratch_.path("pipe").c_str(), 0600);
  EXPECT_THAT(refused(4, {"run", "folder.toml"}), HasSubstr("Is a directory"));
  for (const char* option : {"--like", "--from"}) {
    EXPECT_THAT(refused(4, {"run", option, "folder.toml"}), HasSubstr("Is a directory"));
    EXPECT_THAT(refused(4, {"run", option, "pipe"}), HasSubstr("is a pipe or a device"));
  }
  for (const char* verb : {"info", "verify"}) {
    EXPECT_THAT(refused(4, {verb, "pipe"}), HasSubstr("is a pipe or a device"));
  }
}

TEST_F(Hostile, CtrlCEndsTheWaitForAPipe) {
  ::mkfifo(scratch_.path("pipe").c_str(), 0600);
  for (const char* file : kShaders) {
    std::filesystem::create_symlink("pipe", scratch_.path(file));
  }
  const std::vector<Words> waits{
      {"run", "./pipe"},
      {"explain", "./pipe"},
      {"sweep", "--design", "pipe"},
      {"run", "--steps", "5", "--csv", "pipe"},
      {"run", "--steps", "5", "--pups", "pipe"},
      {"params", "--out", "pipe"},
      {"figure1", "--steps", "1", "--panel", "120", "--quiet", "--out", "pipe"},
      {"render", "--steps", "1", "--size", "64x64", "--no-bar", "--quiet", "--out", "pipe"},
      {"render", "--steps", "1", "--shader-dir", "."},
  };
  for (const Words& words : waits) {
    test::Running running(PUPFLOW_PROGRAM, words, scratch_.folder().string());
    // Before main it would end by the signal itself.
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    running.signal(SIGINT);
    EXPECT_THAT(line(130, running.wait()), HasSubstr("interrupted")) << words[0] << words.back();
  }
}

TEST_F(Hostile, CtrlCEndsTheWaitForAReaderThatSleeps) {
  ::mkfifo(scratch_.path("pipe").c_str(), 0600);
  test::Running reader("/bin/sh", {"-c", "exec sleep 60 < pipe"}, scratch_.folder().string());
  test::Running running(PUPFLOW_PROGRAM,
                        {"run", "--steps", "2000", "--set", "pups=2", "--set", "face_points=2",
                         "--quiet", "--pups", "pipe"},
                        scratch_.folder().string());
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  running.signal(SIGINT);
  EXPECT_THAT(line(130, running.wait()), HasSubstr("interrupted"));
}

TEST_F(Hostile, ScenesComeThroughPipes) {
  const Words words{"--set", "pups=1", "--csv", "-", "--quiet"};
  for (const char* place : {"run -", "run /dev/stdin"}) {
    Words all{"-c", "(sleep 0.3; echo 'steps = 3') | \"$0\" " + std::string(place) + " \"$@\"",
              PUPFLOW_PROGRAM};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = test::run_program("/bin/sh", all, scratch_.folder().string());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("\n3,0.03,"));
  }
}

TEST_F(Hostile, PipesGetAllThatIsWritten) {
  ::mkfifo(scratch_.path("pipe").c_str(), 0600);
  const Words run{"run", "--steps", "300", "--set", "pups=3", "--set", "face_points=2", "--quiet"};
  test::Running reader("/bin/sh", {"-c", "(sleep 0.5; cat) < pipe"}, scratch_.folder().string());
  Words words = run;
  words.insert(words.end(), {"--pups", "pipe"});
  EXPECT_EQ(pupflow(words).code, 0);
  words = run;
  words.insert(words.end(), {"--pups", "file.csv"});
  EXPECT_EQ(pupflow(words).code, 0);
  EXPECT_EQ(reader.wait().out, test::contents(scratch_.path("file.csv")));
}

TEST_F(Hostile, NoControlCharacterReachesTheTerminal) {
  const std::string wild =
      "\x1b[31m\xc2\x9b"
      "31m\x07";
  scratch_.file("scene.toml", "\"ta\\u001b[31m\\u009b\" = 1\n");
  scratch_.file("title.toml",
                "title = \"\\u001b]0;x\\u0007\"\ndescription = \"\\u009b1m\"\nsteps = 1\n");
  scratch_.file("like.csv", "# Software = pupflow 0.2.0\n# ta = " + wild + "\nstep\n");
  scratch_.file("old.csv" + wild, "# Software = pupflow 0.1.0\n# ta = 0.2\nstep\n");
  const std::vector<Words> calls{
      {"run", "scene.toml"},
      {"run", "title.toml", "--set", "pups=1"},
      {"explain", "title.toml"},
      {"info", "title.toml"},
      {"run", "--like", "like.csv"},
      {"run", "--like", "old.csv" + wild, "--set", "pups=1", "--steps", "1"},
      {"info", "like.csv"},
      {"info", wild},
      {"run", wild},
      {"run", "./" + wild},
      {"run", "--like", wild},
      {"run", "--set", wild + "=1"},
      {"run", "--set", "ta=" + wild},
      {"run", "--at", wild},
      {"run", "--csv", wild + "/a.csv", "--steps", "1"},
      {"render", "--out", wild + "/a.png"},
      {"render", "--color-by", wild},
      {"render", "--size", wild},
      {"sweep", "--vary", wild},
      {"sweep", "--design", wild},
      {"merge", wild},
      {"compare", wild, wild},
      {"verify", wild},
      {wild},
      {"run", "--" + wild}};
  for (const Words& words : calls) {
    const Outcome outcome = pupflow(words);
    for (const std::string& text : {outcome.out, outcome.err}) {
      EXPECT_THAT(text,
                  AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("\xc2\x9b")), Not(HasSubstr("\x07"))))
          << testing::PrintToString(words);
    }
    EXPECT_THAT(outcome.out + outcome.err, Not(IsEmpty()));
  }
}

TEST_F(Hostile, ALineBreakInAValueOrPathBeginsNoLine) {
  const std::string forged = "0\npupflow: all fine";
  scratch_.file("scene.toml", "contact = \"a\\npupflow: all fine\"\n");
  scratch_.file("there" + forged, "step\n");
  for (const Words& words : std::vector<Words>{{"run", "scene.toml"},
                                               {"run", "--set", "ta=" + forged},
                                               {"run", "--set", "contact=" + forged},
                                               {"run", "--at", "step=5,ta=" + forged},
                                               {"sweep", "--vary", "ta=" + forged},
                                               {"render", "--scale", forged},
                                               {forged}}) {
    EXPECT_THAT(refused(2, words), HasSubstr("\\x0apupflow"));
  }
  for (const Words& words : std::vector<Words>{{"info", forged},
                                               {"verify", forged},
                                               {"run", "./" + forged},
                                               {"sweep", "--design", forged},
                                               {"run", "--like", forged},
                                               {"run", "--csv", "there" + forged}}) {
    EXPECT_THAT(refused(4, words), HasSubstr("\\x0apupflow"));
  }
}

TEST_F(Hostile, NulDoesNotEndAMessage) {
  scratch_.file("table.csv", std::string("\xff\xfet\0a\0\n\0", 9));
  scratch_.file("like.csv", std::string("# Software = pupflow 0.2.0\n# ta = 0\0.4\nstep\n", 46));
  scratch_.file("scene.toml", "contact = \"a\\u0000c\"\n");
  EXPECT_THAT(pupflow({"sweep", "--design", "table.csv", "--out", "X"}).err,
              HasSubstr("unknown parameter '\\xff\\xfet\\x00a\\x00'"));
  EXPECT_THAT(refused(2, {"run", "--like", "like.csv"}), HasSubstr("0\\x00.4'"));
  EXPECT_THAT(refused(2, {"run", "scene.toml"}), HasSubstr("nearest or mean or sum"));
}

TEST_F(Hostile, WhatAClosedOutputLosesIsToldByTheExitCode) {
  const Words small{"run", "--set", "pups=2", "--steps", "1", "--csv", "-", "--quiet"};
  for (const Words& words : std::vector<Words>{small, {"params"}, {"--help"}}) {
    EXPECT_THAT(line(4, pupflow_behind("exec >&-;", words)),
                HasSubstr("standard output: cannot write"));
    EXPECT_EQ(pupflow_behind("exec 2>&- <&-;", words).code, 0);
  }
}

TEST_F(Hostile, PathsThatCannotBeLookedUpAreToldInOwnWords) {
  const std::string name(300, 'n');
  for (const char* verb : {"info", "verify"}) {
    const std::string told = refused(4, {verb, name});
    EXPECT_THAT(told, AllOf(HasSubstr("File name too long"), Not(HasSubstr("filesystem"))));
  }
}

TEST_F(Hostile, WhatIsNamedLikeARecordingAndIsNoneIsToldSo) {
  scratch_.file("empty.h5", "");
  scratch_.file("text.h5", "step\n");
  for (const char* file : {"empty.h5", "text.h5"}) {
    for (const char* verb : {"info", "verify"}) {
      EXPECT_THAT(refused(2, {verb, file}), HasSubstr("is no recording or checkpoint"));
    }
  }
}

TEST_F(Hostile, PicturesThatCannotBeAreRefusedBeforeTheFirstStep) {
  const Words render{"render", "--set", "pups=1", "--steps", "1000000000", "--quiet", "--no-bar"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), render.begin(), render.end());
    return more;
  };
  EXPECT_THAT(refused(2, with({"--size", "16385x100"})), HasSubstr("each 16 ... 16384"));
  EXPECT_THAT(line(2, pupflow_behind("ulimit -v 4000000; exec",
                                     with({"--size", "16000x16000", "--supersample", "1"}))),
              HasSubstr("of memory, of which"));
  EXPECT_THAT(line(2, pupflow_behind("ulimit -v 2000000; exec", {"figure1", "--steps", "1000000000",
                                                                 "--panel", "4096", "--quiet"})),
              HasSubstr("of memory, of which"));
  const std::string name(300, 'n');
  EXPECT_THAT(refused(4, with({"--out", name + "/%d.png"})), HasSubstr("too long"));
  EXPECT_THAT(refused(4, with({"--out", name + ".png"})), HasSubstr("too long"));
  std::filesystem::create_symlink("nowhere/a.png", scratch_.path("link.png"));
  for (const Words& verb : {render, Words{"figure1", "--steps", "1000000000", "--quiet"}}) {
    Words words = verb;
    words.insert(words.end(), {"--out", "link.png", "--force"});
    refused(4, words);
  }
  EXPECT_THAT(refused(4, {"live", "--screenshots", "nowhere/%d.png"}), HasSubstr("no folder"));
  EXPECT_EQ(scratch_.entries(), 1);
}

TEST_F(Hostile, ScalesOfTheLargestNumbersAreDrawn) {
  const Words small{"--set", "pups=2", "--set", "face_points=2", "--steps", "1", "--quiet"};
  const std::vector<Words> pictures{
      {"render", "--size", "320x240", "--scale", "0,1.7e308", "--celsius", "--out", "a.png"},
      {"render", "--size", "320x240", "--scale", "-8.5e307,9.4e307", "--out", "b.png"},
      {"render", "--grid", "ta=-1e308,1e308", "--panel", "120", "--out", "c.png"},
      {"figure1", "--scale", "0,9.9e307", "--panel", "120", "--out", "d.png"}};
  for (Words words : pictures) {
    words.insert(words.end(), small.begin(), small.end());
    const Outcome outcome = pupflow_behind("exec timeout -k 1 60", words);
    EXPECT_THAT(outcome.code, testing::AnyOf(0, 2, 3)) << outcome.err << words.back();
  }
  EXPECT_TRUE(std::filesystem::exists(scratch_.path("a.png")));
}

TEST_F(Hostile, CtrlCEndsTheDrawingOfOnePicture) {
  const Words large{"--set", "pups=2",        "--set", "face_points=2", "--steps", "1", "--quality",
                    "print", "--supersample", "8",     "--quiet"};
  const std::vector<Words> pictures{{"render", "--size", "8000x8000", "--out", "a.png"},
                                    {"figure1", "--panel", "4096", "--out", "a.png"}};
  for (Words words : pictures) {
    words.insert(words.end(), large.begin(), large.end());
    test::Running running(PUPFLOW_PROGRAM, words, scratch_.folder().string());
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    running.signal(SIGINT);
    EXPECT_THAT(line(130, running.wait()), HasSubstr("interrupted")) << words[0];
    EXPECT_EQ(scratch_.entries(), 0);
  }
}

TEST_F(Hostile, FramesMayHaveFoldersOfTheirOwn) {
  const Outcome outcome = pupflow({"render", "--set", "pups=1", "--at", "0,1", "--size", "64x64",
                                   "--no-bar", "--quiet", "--out", "f%d/a.png"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(scratch_.path("f1/a.png")));
}

TEST_F(Hostile, AFrameThatCannotBeWrittenIsToldBeforeTheNextOneIsReached) {
  EXPECT_THAT(line(4, pupflow_behind("ulimit -f 1; exec", {"render", "--at", "0,1,1000000000",
                                                           "--set", "steps=1000000000", "--size",
                                                           "64x64", "--out", "%d.png", "--quiet"})),
              HasSubstr("0.png: "));
}

TEST_F(Hostile, ALimitOfAddressSpaceIsSeenBeforeTheDriverIsLoaded) {
  for (const char* verb : {"render", "figure1"}) {
    EXPECT_THAT(line(5, pupflow_behind("ulimit -v 400000; exec", {verb, "--quiet"})),
                HasSubstr("address space"));
  }
}

}  // namespace
}  // namespace pupflow
