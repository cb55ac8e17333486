// Scenes, settings and closing of the window.
#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>

#include "app/io/checkpoint.h"
#include "app/io/png.h"
#include "app/io/scene_file.h"
#include "pupflow/simulation.h"
#include "tests/window/live_fixture.h"

namespace pupflow::testing {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class LiveDesk : public Live {
 protected:
  /// A paused window whose litter was edited.
  void open_and_edit(std::vector<std::string> options = {}) {
    options.insert(options.end(), {"--paused", "--seed", "3"});
    open(options);
    type_into_slider("ta", "0.25");
    while (!await("title ").starts_with("untitled*")) {
    }
  }

  /// Types into the dialog's name field, which has the keyboard.
  void answer_name(const std::string& name) {
    await("widget dialog-name ");
    await("text on");
    enter(name);
  }

  static std::string settings_path() { return config_folder() + "/pupflow/settings.toml"; }

  Params scene(const std::string& name) {
    std::vector<std::string> problems;
    const Params params = io::load_scene(scratch_.path(name), problems).params;
    EXPECT_THAT(problems, ::testing::IsEmpty());
    return params;
  }
};

TEST_F(LiveDesk, QuittingWithoutEditsAsksNothing) {
  open({"cold"});
  screen_.press("q");
  EXPECT_EQ(exit_code(), 0);
  EXPECT_EQ(window_->errors(), "");
}

TEST_F(LiveDesk, QuittingAfterEditsAsksAndEscapeGoesOn) {
  open_and_edit();
  screen_.press("q");
  await("widget dialog-discard ");
  screen_.press("Escape");
  screen_.hand({"sleep", "0.5"});
  screen_.press("Right");
  EXPECT_EQ(await("step "), "1") << "the window is still there";
  screen_.press("q");
  screen_.hand({"sleep", "1"});
  click("dialog-discard");
  EXPECT_EQ(exit_code(), 0);
}

TEST_F(LiveDesk, TheWindowSystemsCloseAsksToo) {
  open_and_edit();
  screen_.close_window();
  await("widget dialog-save ");
  screen_.press("Return");
  answer_name("kept");
  EXPECT_EQ(await("saved "), scratch_.path("kept.toml"));
  EXPECT_EQ(exit_code(), 0) << "and goes on closing when it is saved";
  EXPECT_EQ(scene("kept.toml").ambient_temperature, 0.25);
}

TEST_F(LiveDesk, ClosingByTheClockAsksNothing) {
  open_and_edit({"--exit-after", "8"});
  EXPECT_EQ(exit_code(), 0);
}

TEST_F(LiveDesk, ASavedSceneRepeatsWhatWasSeen) {
  open_and_edit();
  screen_.press("shift+Right");
  await("hash 100 ");
  type_into_slider("alpha", "0.55");
  screen_.press("shift+Right");
  const std::string hash = await("hash 200 ");
  screen_.press("ctrl+s");
  answer_name("mine");
  EXPECT_EQ(await("saved "), scratch_.path("mine.toml"));
  EXPECT_THAT(await("title "), StartsWith("mine \u2013"));
  EXPECT_EQ(headless_hash(scene("mine.toml"), 200), hash);
}

TEST_F(LiveDesk, SavesRightAfterAnEditThatIsOnItsWay) {
  open_and_edit();
  screen_.press("ctrl+s");
  answer_name("mine");
  await("title mine \u2013");
  click("ta-field");
  await("text on");
  screen_.hand({"key", "ctrl+a", "type", "--delay", "40", "0.31"});
  settle();
  window_->send_signal(SIGSTOP);  // a frame that takes so long that all keys are in the next one
  screen_.hand({"key", "Return", "ctrl+s", "sleep", "0.3"});
  window_->send_signal(SIGCONT);
  await("title mine*");
  await("title mine \u2013");
  EXPECT_EQ(scene("mine.toml").ambient_temperature, 0.31);
}

TEST_F(LiveDesk, TheCopiedCommandGivesTheSameHash) {
  open({"cold", "--paused", "--seed", "6"});
  screen_.press("shift+Right");
  await("hash 100 ");
  type_into_slider("beta", "0.3");
  screen_.press("shift+Right");
  const std::string hash = await("hash 200 ");
  screen_.press("ctrl+c");
  const std::string command = await("copied ");
  EXPECT_EQ(command, "pupflow run cold --at step=100,beta=0.3 --seed 6 --steps 200");
  const std::string program = std::filesystem::path(PUPFLOW_PROGRAM).parent_path().string();
  Child shell({.arguments = {"sh", "-c", "PATH=" + program + ":$PATH; " + command},
               .environment = {},
               .folder = scratch_.folder().string()});
  std::string printed;
  while (const auto line = shell.read_line()) printed += *line + '\n';
  EXPECT_THAT(printed, HasSubstr(std::string(16 - hash.size(), '0') + hash));
}

TEST_F(LiveDesk, OpensShippedScenesFromTheMenu) {
  open({"--paused"});
  click("menu-Scene");
  click("menu-shipped");
  click("menu-scene-cold");
  EXPECT_EQ(await("opened "), "cold");
  EXPECT_EQ(await("value ta "), "0.2");
}

TEST_F(LiveDesk, OpensFilesByDialogAndSaysWhyOneCannotBe) {
  scratch_.file("broken.toml", "tta = 1\n");
  scratch_.file("fine.toml", "title = 'Fine'\npups = 2\n");
  open({"--paused"});
  screen_.press("ctrl+o");
  answer_name("broken.toml");
  EXPECT_THAT(await("refused "), HasSubstr("unknown key 'tta'"));
  click("file-fine.toml");
  screen_.hand({"sleep", "0.3"});
  click("dialog-accept");
  EXPECT_EQ(await("opened "), scratch_.path("fine.toml"));
  EXPECT_EQ(await("value pups "), "2");
}

TEST_F(LiveDesk, OpensARecentFileFromTheMenuOfTheNextWindow) {
  scratch_.file("fine.toml", "title = 'Fine'\npups = 2\n");
  open({"--paused"});
  screen_.press("ctrl+o");
  answer_name("fine.toml");
  EXPECT_EQ(await("opened "), scratch_.path("fine.toml"));
  screen_.press("q");
  EXPECT_EQ(exit_code(), 0);
  open({"--paused"});
  click("menu-Scene");
  click("menu-recent");
  click("menu-recent-0");
  EXPECT_EQ(await("opened "), scratch_.path("fine.toml"));
  EXPECT_EQ(await("value pups "), "2");
}

TEST_F(LiveDesk, OpensACheckpointWithItsLitter) {
  Params params;
  params.seed = 12;
  Simulation simulation(params);
  simulation.run(30);
  io::write_checkpoint(scratch_.path("litter.h5"), false, simulation);
  open({"--paused"});
  screen_.press("ctrl+o");
  answer_name("litter.h5");
  await("opened ");
  EXPECT_EQ(await("hash 30 "), headless_hash(params, 30));
}

TEST_F(LiveDesk, OpeningOverEditsAsksFirst) {
  scratch_.file("fine.toml", "pups = 2\n");
  open_and_edit();
  screen_.press("ctrl+o");
  answer_name("fine.toml");
  await("widget dialog-discard ");
  screen_.hand({"sleep", "0.3"});
  click("dialog-discard");
  EXPECT_EQ(await("value pups "), "2");
}

TEST_F(LiveDesk, SettingsAreKeptForTheNextWindow) {
  open({"--paused", "--size", "1000x700"});
  screen_.press("ctrl+plus");
  screen_.press("ctrl+d");
  screen_.press("h");
  click("menu-Run");
  click("pause_minimised");
  await("gone pause_minimised");
  screen_.hand({"sleep", "0.5"});
  screen_.press("q");
  EXPECT_EQ(exit_code(), 0);
  const std::string kept = test::contents(settings_path());
  EXPECT_THAT(kept, HasSubstr("theme = \"dark\""));
  EXPECT_THAT(kept, HasSubstr("panels = false"));
  EXPECT_THAT(kept, HasSubstr("pause_minimised = true"));
  EXPECT_THAT(kept, HasSubstr("ui_scale = 1.1"));
  EXPECT_THAT(kept, HasSubstr("width = 1400")) << "an option is no setting";
  open({"--paused"});
  EXPECT_EQ(widgets().count("ta"), 0u) << "the panels are still closed";
  click("menu-Run");
  click("pause_minimised");
  await("gone pause_minimised");
  screen_.press("q");
  EXPECT_EQ(exit_code(), 0);
  EXPECT_THAT(test::contents(settings_path()), HasSubstr("pause_minimised = false")) << "it was on";
}

TEST_F(LiveDesk, BrokenSettingsAreSetAsideAndTheWindowOpens) {
  std::filesystem::create_directories(std::filesystem::path(settings_path()).parent_path());
  std::ofstream(settings_path()) << "theme = 7\n";
  open({"--paused"});
  screen_.press("q");
  EXPECT_EQ(exit_code(), 0);
  EXPECT_THAT(window_->errors(), HasSubstr("theme must be light or dark; it is now "));
  EXPECT_EQ(test::contents(settings_path() + ".broken"), "theme = 7\n");
}

TEST_F(LiveDesk, WithoutAPlaceForSettingsTheWindowWorksOn) {
  scratch_.file("file", "");
  open({"--paused"}, {"XDG_CONFIG_HOME=" + scratch_.path("file")});
  screen_.press("ctrl+d");
  screen_.press("Right");
  EXPECT_EQ(await("step "), "1");
  screen_.press("q");
  EXPECT_EQ(exit_code(), 0);
  EXPECT_THAT(window_->errors(), HasSubstr("settings are not kept: "));
}

TEST_F(LiveDesk, AFilmHasEveryFrameAndTheSimulationWaitsForThem) {
  open({"--paused", "--seed", "2"});
  screen_.press("v");
  await("step 12");  // four steps of 0.01 s between two of 25 frames a second: 4, 8, 12
  click("record");
  const std::string film = scratch_.path(await("filmed "));
  Child probe(
      {.arguments = {"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                     "stream=nb_read_frames:format_tags=comment", "-of", "default=nk=1", film},
       .environment = {},
       .folder = {}});
  std::string said;
  while (const auto line = probe.read_line()) said += *line + '\n';
  EXPECT_GE(std::stoi(said.substr(said.find('\n') + 1)), 3) << said;
  EXPECT_THAT(said, HasSubstr("# seed = 2"));
}

/// A press is handled where the mouse was, though it has gone on by the next frame.
TEST_F(LiveDesk, AButtonPressedRightAfterAnEntryOfAListIsPressed) {
  open({"--paused", "--out", "shot.png"});
  settle();
  click("picture-sizes");
  const Box entry = widget("picture-4k"), button = widget("screenshot");
  settle();
  std::vector<std::string> hand;
  for (const Box& box : {entry, button}) {
    hand.insert(hand.end(), {"mousemove", std::to_string(box.middle_x()),
                             std::to_string(box.middle_y()), "click", "1"});
  }
  hand.insert(hand.end(), {"mousemove", "5", "400"});
  window_->send_signal(SIGSTOP);  // all of it between two frames
  screen_.hand(hand);
  window_->send_signal(SIGCONT);
  const io::Image image = io::read_png(scratch_.path(await("screenshot ")));
  EXPECT_EQ(image.width, 3840);
}

TEST_F(LiveDesk, AFilmHasTheSizeThatIsChosen) {
  open({"--paused", "--set", "pups=2"});
  click("picture-sizes");
  settle();
  click("picture-pixels");
  await("text on");
  type("320x240");
  screen_.press("Escape");
  settle();
  screen_.press("v");
  await("step 8");
  screen_.press("v");
  const std::string film = scratch_.path(await("filmed "));
  Child probe({.arguments = {"ffprobe", "-v", "error", "-show_entries", "stream=width,height",
                             "-of", "csv=p=0", film},
               .environment = {},
               .folder = {}});
  EXPECT_EQ(probe.read_line(), "320,240");
}

TEST_F(LiveDesk, WithoutFfmpegOneLineSaysWhatToInstall) {
  open({"--paused"}, {"PATH=/nowhere"});
  screen_.press("v");
  EXPECT_THAT(await("refused "), HasSubstr("apt install ffmpeg"));
}

TEST_F(LiveDesk, FullScreenAndBack) {
  open({"--paused", "--size", "900x600"});
  screen_.press("Right");
  await("step 1");  // the window has its final layout by then
  const int low = widget("play").y;
  screen_.press("F11");
  Box box = widget("play");
  while (box.y <= low) {
    await("widget play ");
    box = widget("play");
  }
  screen_.hand({"sleep", "1"});  // without a window manager the keyboard comes back late
  screen_.press("F11");
  while (box.y != low) {
    await("widget play ");
    box = widget("play");
  }
}

}  // namespace
}  // namespace pupflow::testing
