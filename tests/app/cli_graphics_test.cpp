// The verbs that need the graphics module: without it, and with a fake one that prints its job.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "app/io/png.h"
#include "app/io/provenance.h"
#include "program.h"
#include "tests/support/scratch.h"

namespace pupflow {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class CliGraphics : public testing::Test {
 protected:
  CliGraphics() { fs::copy_file(PUPFLOW_PROGRAM, program()); }

  void give_module() const {
    fs::copy_file(PUPFLOW_FAKE_GRAPHICS, scratch_.path("libpupflow_graphics.so"));
  }

  std::string program() const { return scratch_.path("pupflow"); }
  /// Without the line that says what was written, which the fake module did not write.
  Outcome pupflow(const std::vector<std::string>& arguments) const {
    Outcome outcome = test::run_program(program(), arguments, scratch_.folder().string());
    if (outcome.out.starts_with("wrote ")) outcome.out.erase(0, outcome.out.find('\n') + 1);
    return outcome;
  }
  std::string refused(const std::vector<std::string>& arguments) const {
    const Outcome outcome = pupflow(arguments);
    EXPECT_EQ(outcome.code, 2) << testing::PrintToString(arguments);
    EXPECT_THAT(outcome.out, IsEmpty());
    return outcome.err;
  }

  test::Scratch scratch_;
};

TEST_F(CliGraphics, WithoutTheModuleOnlyPicturesFail) {
  EXPECT_EQ(pupflow({"run", "--steps", "1"}).code, 0);
  const std::vector<std::vector<std::string>> calls{{"render"}, {"figure1"}, {"live"}};
  for (const auto& call : calls) {
    const Outcome outcome = pupflow(call);
    EXPECT_EQ(outcome.code, 5);
    EXPECT_THAT(outcome.err, StartsWith("pupflow: no graphics: "));
    EXPECT_THAT(outcome.err, HasSubstr(scratch_.path("libpupflow_graphics.so")));
    EXPECT_THAT(outcome.err, HasSubstr("apt install"));
  }
  const Outcome doctor = pupflow({"doctor"});
  EXPECT_EQ(doctor.code, 0);
  // Parts of a build are looked for beside the program, which stands alone here.
  for (const char* part : {"mpi        no module", "python     no module",
                           "sweeps over several machines need MPI: apt install libopenmpi-dev",
                           "scripts in Python need pybind11: apt install python3-dev"}) {
    EXPECT_THAT(doctor.out, HasSubstr(part));
  }
  EXPECT_EQ(scratch_.entries(), 1);
}

TEST_F(CliGraphics, AModuleThatDoesNotLoadIsReportedWithTheReason) {
  scratch_.file("libpupflow_graphics.so", std::string(4096, '?'));
  const Outcome outcome = pupflow({"figure1"});
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("invalid ELF header"));
}

TEST_F(CliGraphics, IsFoundInTheInstalledPlaceToo) {
  fs::create_directories(scratch_.path("bin"));
  const fs::path library = (scratch_.folder() / "bin" / PUPFLOW_MODULE_FOLDER).lexically_normal();
  fs::create_directories(library);
  fs::copy_file(PUPFLOW_FAKE_GRAPHICS, library / "libpupflow_graphics.so");
  fs::rename(program(), scratch_.path("bin/pupflow"));
  EXPECT_EQ(test::run_program(scratch_.path("bin/pupflow"), {"figure1"}, "/").code, 0);
}

TEST_F(CliGraphics, RenderHandsOverItsJob) {
  give_module();
  const Outcome plain = pupflow({"render", "--steps", "40"});
  EXPECT_EQ(plain.code, 0) << plain.err;
  EXPECT_EQ(plain.out,
            "render seed=1 at 40\n1280x960 camera=orbit:30,35 bar=1\n"
            "tb by viridis nan..nan n=1 verbose=0 shaders='' out=frames/%05d.png force=0 quiet=0\n"
            "draw=skin quality=normal overlay= trail=1 caption=0 transparent=0 dpi=0\n");
  const Outcome full = pupflow(
      {"render",  "cold",          "--seed", "9",         "--at",         "30,0,30,2", "--size",
       "64x48",   "--camera",      "top",    "--no-bar",  "--colormap",   "cividis",   "--scale",
       "-1,0.5",  "--supersample", "3",      "--verbose", "--shader-dir", ".",         "--out",
       "a%d.png", "--force",       "--quiet"});
  EXPECT_EQ(full.out,
            "render seed=9 at 0 2 30\n64x48 camera=top bar=0\n"
            "tb by cividis -1..0.5 n=3 verbose=1 shaders='.' out=a%d.png force=1 quiet=1\n"
            "draw=skin quality=normal overlay= trail=1 caption=0 transparent=0 dpi=0\n");
  EXPECT_THAT(pupflow({"render", "--every", "10", "--steps", "35"}).out,
              HasSubstr("at 10 20 30\n"));
}

TEST_F(CliGraphics, PicturesSayWhatTheyWrote) {
  give_module();
  const auto said = [&](const std::vector<std::string>& arguments) {
    const std::string out = test::run_program(program(), arguments, scratch_.folder().string()).out;
    return out.substr(0, out.find('\n'));
  };
  EXPECT_EQ(said({"render", "--steps", "40"}), "wrote frames/00040.png");
  EXPECT_EQ(said({"render", "--at", "1,3,9", "--out", "a%d.png"}),
            "wrote 3 pictures, a1.png to a9.png");
  EXPECT_EQ(said({"render", "--grid", "ta=0,1"}), "wrote grid.png");
  EXPECT_EQ(said({"figure1"}), "wrote figure1.png");
  EXPECT_THAT(said({"figure1", "--quiet"}), StartsWith("figure1 "));
}

TEST_F(CliGraphics, AnyFieldIsShownInColorsByItsOwnScale) {
  give_module();
  const auto look = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "--steps", "1"});
    const std::string out = pupflow(options).out;
    const std::string last = out.substr(out.find('\n', out.find('\n') + 1) + 1);
    return last.substr(0, last.find(" n="));
  };
  EXPECT_EQ(look({"--color-by", "exposed"}), "exposed by viridis nan..nan");
  EXPECT_EQ(look({"--color-by", "exposed", "--scale", "field"}), "exposed by viridis 0..1");
  EXPECT_EQ(look({"--scale", "around-tp"}), "tb by bluered nan..nan");
  EXPECT_EQ(look({"--color-by", "strain", "--scale", "0,0.1"}), "strain by viridis 0..0.1");
  EXPECT_EQ(look({"--color-by", "deformation"}), "deformation by viridis nan..nan");
  EXPECT_EQ(look({"--color-by", "turn", "--scale", "field"}), "turn by bluered -1.5708..1.5708");
  EXPECT_EQ(look({"--color-by", "heading"}), "heading by phase -3.14159..3.14159");
  EXPECT_EQ(look({"--color-by", "side"}), "side by  0..1");
  EXPECT_THAT(pupflow({"figure1", "--color-by", "group"}).out, HasSubstr("group by "));
  EXPECT_THAT(pupflow({"figure1"}).out, HasSubstr("tb by viridis 0..1"));
}

TEST_F(CliGraphics, TheLookIsHandedOver) {
  give_module();
  const std::string out = pupflow({"render", "--draw", "both", "--quality", "print", "--overlay",
                                   "ids,contacts,trails", "--trail", "2.5", "--caption",
                                   "--transparent", "--dpi", "300", "--target", "0.5,-1,0.3"})
                              .out;
  EXPECT_THAT(out, HasSubstr("target=0.5,-1,0.3\n"));
  EXPECT_THAT(out, HasSubstr("n=3 "));
  EXPECT_THAT(out,
              HasSubstr("draw=both quality=print overlay=trails,contacts,ids trail=2.5 caption=1 "
                        "transparent=1 dpi=300\n"));
  EXPECT_THAT(pupflow({"render", "--follow", "3"}).out, HasSubstr("follow=3\n"));
}

TEST_F(CliGraphics, LikeAPictureGivesItsLookBack) {
  give_module();
  Params params;
  params.seed = 7;
  const io::TextEntries extra{{"picture", "render"},       {"step", "300"},
                              {"camera", "orbit:10,20,9"}, {"camera_target", "0.5,1,0.25"},
                              {"size", "320x200"},         {"bar", "false"},
                              {"color_by", "exposed"},     {"colormap", "inferno"},
                              {"scale", "0.1,0.4"},        {"draw", "points"},
                              {"quality", "fast"},         {"supersample", "2"},
                              {"overlay", "ids"},          {"trail", "3"},
                              {"caption", "true"},         {"dpi", "150"}};
  io::write_png(scratch_.path("f.png"), io::Image(2, 2), io::provenance(params, extra), false);
  EXPECT_EQ(pupflow({"render", "--like", "f.png"}).out,
            "render seed=7 at 300\n320x200 camera=orbit:10,20,9 bar=0 target=0.5,1,0.25\n"
            "exposed by inferno 0.1..0.4 n=2 verbose=0 shaders='' out=frames/%05d.png force=0 "
            "quiet=0\n"
            "draw=points quality=fast overlay=ids trail=3 caption=1 transparent=0 dpi=150\n");
  // What is typed changes what it names, and what depends on it.
  const std::string typed = pupflow({"render", "--like", "f.png", "--color-by", "tb", "--quality",
                                     "print", "--at", "5", "--camera", "top"})
                                .out;
  EXPECT_THAT(typed, HasSubstr("at 5\n320x200 camera=top bar=0\n"));
  EXPECT_THAT(typed, HasSubstr("tb by viridis nan..nan n=3 "));
  EXPECT_THAT(typed, HasSubstr("draw=points quality=print overlay=ids "));
}

TEST_F(CliGraphics, WhatIsWrongWithAPictureNamesThePicture) {
  give_module();
  const auto error = [&](const io::TextEntries& extra, std::vector<std::string> more = {}) {
    io::TextEntries entries{{"picture", "render"}, {"camera", "top"}};
    entries.insert(entries.end(), extra.begin(), extra.end());
    io::write_png(scratch_.path("f.png"), io::Image(2, 2), io::provenance(Params{}, entries), true);
    more.insert(more.begin(), {"render", "--like", "f.png"});
    return refused(more);
  };
  EXPECT_THAT(error({{"size", "99999x99999"}}), StartsWith("pupflow: f.png: size '99999x99999': "));
  EXPECT_THAT(error({{"color_by", "groop"}}),
              StartsWith("pupflow: f.png: color_by: unknown field 'groop'"));
  EXPECT_THAT(error({{"camera_target", "1,2"}}), StartsWith("pupflow: f.png: camera_target '1,2'"));
  EXPECT_THAT(error({{"scale", "1,0"}}), StartsWith("pupflow: f.png: scale "));
  EXPECT_THAT(error({{"size", "1x1"}}, {"--size", "2x2"}), StartsWith("pupflow: --size '2x2': "));
  io::write_png(scratch_.path("f.png"), io::Image(2, 2),
                {{"Software", "pupflow 0.2.0"}, {"ta", "0\npupflow: all fine"}}, true);
  EXPECT_THAT(refused({"run", "--like", "f.png"}), HasSubstr("'0\\x0apupflow: all fine'"));
}

TEST_F(CliGraphics, ColorByRefusesWhatCannotBe) {
  for (const char* verb : {"render", "figure1", "live"}) {
    EXPECT_EQ(refused({verb, "--color-by", "groop"}),
              "pupflow: --color-by: unknown field 'groop'; did you mean 'group'?\n");
  }
  EXPECT_THAT(refused({"render", "--color-by", "warmth"}), HasSubstr("one of tb, "));
  EXPECT_THAT(refused({"render", "--color-by", "mean_tb"}), HasSubstr("unknown field"));
  EXPECT_EQ(refused({"render", "--color-by", "group", "--scale", "0,1"}),
            "pupflow: --scale 0,1: group is categorical: it has no scale\n");
  EXPECT_THAT(refused({"render", "--color-by", "heading", "--scale", "0,1"}), HasSubstr("angle"));
  EXPECT_THAT(refused({"live", "--color-by", "side", "--colormap", "jet"}),
              HasSubstr("categorical"));
  refused({"render", "--color-by", ""});
}

TEST_F(CliGraphics, ASecondOfAFilmIsASecondOfTheModelUnlessAsked) {
  give_module();
  const auto film = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "--movie", "a.mp4", "--steps", "20"});
    return pupflow(options).out;
  };
  EXPECT_THAT(film({}), AllOf(HasSubstr("at 4 8 12 16 20\n"), HasSubstr(" fps=25\n"),
                              HasSubstr("out=a.mp4")));
  EXPECT_THAT(film({"--fps", "10"}), AllOf(HasSubstr("at 10 20\n"), HasSubstr(" fps=10\n")));
  EXPECT_THAT(film({"--set", "dt=0.04"}), HasSubstr("at 1 2 3 4"));
  EXPECT_THAT(film({"--every", "7"}), HasSubstr("at 7 14\n"));
  EXPECT_THAT(film({"--at", "3,5"}), HasSubstr("at 3 5\n"));
}

TEST_F(CliGraphics, RefusesFilmsThatCannotBe) {
  give_module();
  const auto film = [&](std::vector<std::string> options) {
    options.insert(options.begin(), "render");
    return refused(options);
  };
  EXPECT_THAT(film({"--movie", "a.avi"}), HasSubstr(".mp4, .webm or .gif"));
  EXPECT_THAT(film({"--movie", ""}), HasSubstr("--movie"));
  EXPECT_THAT(film({"--movie", "a.gif", "--fps", "60"}), HasSubstr("1 to 50"));
  EXPECT_THAT(film({"--movie", "a.mp4", "--fps", "0"}), HasSubstr("--fps"));
  EXPECT_THAT(film({"--fps", "30"}), HasSubstr("--movie"));
  EXPECT_THAT(film({"--movie", "a.mp4", "--out", "%d.png"}), HasSubstr("use one"));
  EXPECT_THAT(film({"--movie", "a.mp4", "--size", "16384x16384"}), HasSubstr("too large"));
  EXPECT_EQ(
      film({"--movie", "a.mp4", "--steps", "3"}),
      "pupflow: --movie a.mp4: a frame every 4 steps gives 0 frames over 3 steps; must be 1 to "
      "1000000; see --every and --steps\n");
}

TEST_F(CliGraphics, AGridIsHandedOver) {
  give_module();
  EXPECT_THAT(
      pupflow({"render", "cold", "--grid", "ta=0.2:0.8:3", "--steps", "9", "--threads", "2"}).out,
      AllOf(StartsWith("sheet seed=1 steps=9 panel=560 threads=2 camera=orbit:30,35 bar=1 "
                       "ta 0.2 0.5 0.8\n"),
            HasSubstr("out=grid.png")));
  EXPECT_THAT(pupflow({"render", "--grid", "seed=3..5", "--grid", "contact=nearest,sum", "--panel",
                       "200", "--no-bar", "--camera", "top", "--out", "a.png"})
                  .out,
              AllOf(HasSubstr("panel=200"), HasSubstr("camera=top bar=0 seed 3 4 5 contact 0 2\n"),
                    HasSubstr("out=a.png")));
}

TEST_F(CliGraphics, LikeGivesAGridBack) {
  give_module();
  const io::TextEntries extra{{"picture", "grid"}, {"grid", "ta=0.2,0.5 seed=4,5"},
                              {"panel", "300"},    {"bar", "false"},
                              {"camera", "top"},   {"color_by", "tb"},
                              {"scale", "0,1"}};
  io::write_png(scratch_.path("g.png"), io::Image(4, 4), io::provenance(Params{}, extra), false);
  EXPECT_THAT(pupflow({"render", "--like", "g.png", "--threads", "1"}).out,
              StartsWith("sheet seed=1 steps=1500 panel=300 threads=1 camera=top bar=0 ta 0.2 0.5 "
                         "seed 4 5\n"));
  EXPECT_THAT(pupflow({"render", "--like", "g.png", "--grid", "pups=1..3", "--panel", "200"}).out,
              AllOf(HasSubstr("panel=200"), HasSubstr("bar=0 pups 1 2 3\n")));
  EXPECT_EQ(refused({"render", "--like", "g.png", "--size", "64x64"}),
            "pupflow: --size: does not go with the panels of --like\n");
}

TEST_F(CliGraphics, RefusesGridsThatCannotBe) {
  give_module();
  const auto grid = [&](const std::string& text, std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"render", "--grid", text});
    return refused(options);
  };
  EXPECT_THAT(grid("warmth=1,2"), HasSubstr("warmth"));
  EXPECT_THAT(grid("ta"), StartsWith("pupflow: --grid 'ta'"));
  EXPECT_THAT(grid("ta=a,b"), HasSubstr("--grid"));
  EXPECT_THAT(grid("seed=6..1"), HasSubstr("the smaller first"));
  EXPECT_THAT(grid("seed=1..1000000000000"), HasSubstr("at most 100 panels"));
  EXPECT_THAT(grid("ta=0:1:11", {"--grid", "beta=0:1:10"}), HasSubstr("at most 100 panels"));
  EXPECT_THAT(grid("ta=0,1", {"--grid", "ta=0.5,0.6"}), HasSubstr("twice"));
  EXPECT_THAT(grid("ta=0,1", {"--grid", "beta=0,1", "--grid", "seed=1,2"}), HasSubstr("not 3"));
  EXPECT_THAT(grid("ta=0,1", {"--set", "ta=0.5"}), HasSubstr("its own ta"));
  EXPECT_THAT(grid("ta=0,1", {"--movie", "a.mp4"}), HasSubstr("--movie"));
  EXPECT_THAT(grid("ta=0,1", {"--size", "64x64"}), HasSubstr("--size"));
  EXPECT_THAT(grid("ta=0,1", {"--at", "5"}), HasSubstr("--steps"));
  EXPECT_THAT(grid("ta=0,1", {"--out", "%d.png"}), HasSubstr("without %"));
  EXPECT_THAT(refused({"render", "--panel", "200"}), HasSubstr("--grid"));
}

TEST_F(CliGraphics, RenderRefusesBadOptions) {
  refused({"render", "--camera", "sideways"});
  refused({"render", "--colormap", "rainbow"});
  refused({"render", "--size", "0x10"});
  refused({"render", "--size", "640"});
  refused({"render", "--scale", "1,0"});
  refused({"render", "--scale", "0"});
  refused({"render", "--supersample", "0"});
  EXPECT_THAT(refused({"render", "--draw", "skins"}), HasSubstr("points or skin or both"));
  EXPECT_THAT(refused({"figure1", "--quality", ""}), HasSubstr("fast or normal or print"));
  EXPECT_THAT(refused({"figure1", "--overlay", "trail"}), HasSubstr("did you mean 'trails'?"));
  EXPECT_THAT(refused({"render", "--scale", "around-tp", "--color-by", "speed"}),
              HasSubstr("no temperature"));
  for (const char* scale : {"automatic", "0,nan", "1,0", "0,1,2"}) {
    EXPECT_THAT(refused({"figure1", "--scale", scale}),
                HasSubstr("must be auto, around-tp, field or MIN,MAX with MIN < MAX, e.g. 0,1"));
  }
  EXPECT_THAT(refused({"render", "--scale", "-1e308,1e308"}), HasSubstr("too far apart"));
  EXPECT_THAT(refused({"render", "--target", "here"}), HasSubstr("X,Y,Z in arena units"));
  for (const char* trail : {"0", "nan", "inf", "", "long"}) {
    EXPECT_THAT(refused({"render", "--trail", trail}),
                HasSubstr("must be a number from 0.01 to 1000"));
  }
  EXPECT_THAT(refused({"render", "--dpi", "1.5"}), HasSubstr("a whole number from 1 to 4800"));
  EXPECT_THAT(refused({"render", "--follow", ""}), HasSubstr("a whole number from 0"));
  EXPECT_THAT(refused({"live", "--ui-scale", "nan"}), HasSubstr("a number from 0.5 to 4"));
  refused({"render", "--target", "1,2"});
  refused({"render", "--target", "1,2,1e9"});
  refused({"render", "--target", "1,2,3", "--follow", "1"});
  refused({"render", "--follow", "first"});
  refused({"render", "--at", "1,-2"});
  refused({"render", "--at", "1", "--every", "2"});
  refused({"render", "--every", "2000"});
  EXPECT_THAT(refused({"render", "--at", "1,2", "--out", "a.png"}), HasSubstr("%05d"));
  refused({"render", "--out", "%s.png"});
  refused({"figure1", "--ta", "0.2,"});
  EXPECT_THAT(refused({"figure1", "--set", "ta=0.2"}), HasSubstr("use --ta 0.2"));
  refused({"live", "--size", "big"});
  refused({"live", "--screenshots", "%x.png"});
  EXPECT_EQ(refused({"render", "--out", "a.mp4"}),
            "pupflow: --out 'a.mp4': pictures are PNG; the name must end in .png\n");
  EXPECT_THAT(refused({"render", "--grid", "ta=0,1", "--out", "a.jpg"}), HasSubstr("in .png"));
  EXPECT_THAT(refused({"figure1", "--out", "a.pdf"}), HasSubstr("in .png"));
  EXPECT_THAT(refused({"figure1", "--out", "%d.png"}), HasSubstr("without %"));
  EXPECT_THAT(refused({"live", "--out", "a.jpg"}), HasSubstr("in .png"));
}

TEST_F(CliGraphics, Figure1HandsOverItsJob) {
  give_module();
  EXPECT_THAT(pupflow({"figure1", "--threads", "3"}).out,
              StartsWith("figure1 seed=1 panel=560 threads=3 ta 0.2 0.5 0.8\n"));
  EXPECT_THAT(pupflow({"figure1", "--ta", "-0.5,1", "--panel", "120", "--seed", "3", "--threads",
                       "2", "--out", "f.png"})
                  .out,
              testing::AllOf(StartsWith("figure1 seed=3 panel=120 threads=2 ta -0.5 1\n"),
                             HasSubstr("out=f.png")));
  scratch_.file("f.png", "precious");
  EXPECT_EQ(pupflow({"figure1", "--out", "f.png"}).code, 4);
}

TEST_F(CliGraphics, LikeAFigure1GivesItBack) {
  give_module();
  Params params;
  params.seed = 7;
  const io::TextEntries extra{{"picture", "figure1"}, {"panels_ta", "0.3,0.4"}, {"panel", "130"},
                              {"color_by", "tb"},     {"scale", "0.1,0.4"},     {"draw", "points"}};
  io::write_png(scratch_.path("f.png"), io::Image(2, 2), io::provenance(params, extra), false);
  EXPECT_THAT(pupflow({"figure1", "--like", "f.png", "--threads", "1"}).out,
              AllOf(StartsWith("figure1 seed=7 panel=130 threads=1 ta 0.3 0.4\n"),
                    HasSubstr("0.1..0.4 "), HasSubstr("draw=points ")));
  EXPECT_THAT(pupflow({"figure1", "--like", "f.png", "--threads", "1", "--ta", "0.5", "--panel",
                       "200", "--draw", "skin"})
                  .out,
              AllOf(StartsWith("figure1 seed=7 panel=200 threads=1 ta 0.5\n"),
                    HasSubstr("0.1..0.4 "), HasSubstr("draw=skin ")));
}

TEST_F(CliGraphics, LiveHandsOverItsJobAndItsFailure) {
  give_module();
  const Outcome outcome = pupflow({"live", "--size", "800x600", "--ui-scale", "1.5", "--paused",
                                   "--screenshots", "s%d.png", "--test-events"});
  EXPECT_EQ(outcome.out, "live 800x600 ui=1.5 paused=1 shots=s%d.png events=1\n");
  EXPECT_EQ(outcome.err, "pupflow: no display was found\n");
  EXPECT_EQ(outcome.code, 5);
}

TEST_F(CliGraphics, TheModuleSeesAnInterrupt) {
  give_module();
  test::Running running(program(), {"live", "--exit-after", "1"}, scratch_.folder().string());
  while (!fs::exists(scratch_.path("ready"))) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  running.signal(SIGINT);
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.err, "pupflow: the module saw it\n");
  EXPECT_EQ(outcome.code, 130);
}

TEST_F(CliGraphics, DoctorTellsWhatWasTried) {
  give_module();
  const Outcome outcome = pupflow({"doctor"});
  EXPECT_EQ(outcome.code, 0);
  for (const char* part : {"works: EGL fake", "renderer of paper", "tried first: no",
                           "does not work", "tried GLFW: no DISPLAY", "needs a display"}) {
    EXPECT_THAT(outcome.out, HasSubstr(part));
  }
}

}  // namespace
}  // namespace pupflow
