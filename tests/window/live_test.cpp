// `pupflow live` as somebody at the screen meets it.
#include <gmock/gmock.h>

#include <csignal>
#include <cstdlib>
#include <string>

#include "app/io/params_of_file.h"
#include "app/io/png.h"
#include "app/io/provenance.h"
#include "pupflow/parameters.h"
#include "tests/window/live_fixture.h"

namespace pupflow::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST_F(Live, PlaysAtOnceAndClosesByKey) {
  open();
  EXPECT_GT(std::stoll(await("step ")), 0);
  screen_.press("q");
  EXPECT_EQ(exit_code(), 0);
  EXPECT_EQ(window_->errors(), "");
}

TEST_F(Live, ADraggedSliderChangesTaInTheRunningSimulation) {
  open({"--set", "ta=0.4"});
  const std::int64_t before = std::stoll(await("step "));
  const Box box = widget("ta");
  screen_.press_and_move(box.x + 2 * box.width / 5, box.middle_y(), box.x + 3 * box.width / 4,
                         box.middle_y());
  double ta = 0.4;
  while (ta < 0.7) ta = std::stod(await("value ta "));
  screen_.release();
  EXPECT_NEAR(ta, 0.75, 0.05);
  EXPECT_GT(std::stoll(await("step ")), before) << "the run went on, without a restart";
}

TEST_F(Live, SpaceStopsAndStartsTheSteps) {
  open();
  await("step ");
  screen_.press("space");
  EXPECT_EQ(await("state "), "paused");
  const std::int64_t paused_at = std::stoll(await("step "));
  screen_.press("Right");
  EXPECT_EQ(std::stoll(await("step ")), paused_at + 1) << "a single step, and none before it";
  screen_.press("space");
  EXPECT_EQ(await("state "), "playing");
  EXPECT_GT(std::stoll(await("step ")), paused_at + 1);
}

TEST_F(Live, ThePictureCarriesTheRecipeWithItsEdits) {
  open({"--paused", "--seed", "9", "--out", "shot-%03d.png"});
  screen_.press("Right");
  await("hash 1 ");
  type_into_slider("ta", "0.2345");
  EXPECT_EQ(await("value ta "), "0.2345");
  screen_.press("s");
  EXPECT_EQ(await("screenshot "), "shot-001.png");
  screen_.press("F12");
  EXPECT_EQ(await("screenshot "), "shot-001-2.png");

  const std::string path = scratch_.path("shot-001.png");
  Params expected;
  expected.seed = 9;
  const auto ta = static_cast<std::size_t>(find_parameter("ta") - parameters().data());
  expected.schedule.set(1, ta, 0.2345);
  EXPECT_EQ(io::params_of_file(path), expected);
  const io::TextEntries text = io::read_png_text(path);
  EXPECT_THAT(text, ::testing::Contains(::testing::Pair("step", "1")));
  EXPECT_THAT(text, ::testing::Contains(::testing::Key("hash")));
  const io::Image image = io::read_png(path);
  EXPECT_THAT(text, ::testing::Contains(::testing::Pair(
                        "size", std::to_string(image.width) + "x" + std::to_string(image.height))));
}

TEST_F(Live, TheFieldInColorsIsTheOneOfTheCommandLineAndThenTheChosenOne) {
  open({"--paused", "--color-by", "heading", "--out", "shot-%d.png"});
  const auto shown_field = [&] {
    screen_.press("s");
    for (const auto& [key, value] : io::read_png_text(scratch_.path(await("screenshot ")))) {
      if (key == "color_by") return value;
    }
    return std::string();
  };
  EXPECT_EQ(shown_field(), "heading");
  click("color_by");
  click("color_by-strain");
  EXPECT_EQ(shown_field(), "strain");
}

TEST_F(Live, TheSameHashAsHeadless) {
  open({"--paused", "--seed", "5", "--set", "ta=0.3"});
  screen_.press("shift+n");
  const std::string hash = await("hash 100 ");
  Params params;
  params.seed = 5;
  params.ambient_temperature = 0.3;
  EXPECT_EQ(hash, headless_hash(params, 100));
}

TEST_F(Live, RestartsByKeyAndByButton) {
  open({"--paused"});
  const std::string start = headless_hash(Params{}, 0);
  for (const bool by_key : {true, false}) {
    screen_.press("Right");
    await("hash 1 ");
    if (by_key) {
      screen_.press("r");
    } else {
      click("restart");
    }
    EXPECT_EQ(await("hash 0 "), start);
  }
}

TEST_F(Live, F1ShowsTheHelpAndEscapeClosesItFirst) {
  open({"--paused"});
  screen_.press("F1");
  EXPECT_EQ(await("help "), "shown");
  screen_.press("Escape");
  EXPECT_EQ(await("help "), "hidden");
  screen_.press("Escape");
  screen_.press("Right");
  EXPECT_EQ(await("step "), "1") << "the window is still there";
  screen_.press("q");
  EXPECT_EQ(exit_code(), 0);
}

TEST_F(Live, TheSeedCanBeTypedAndKeysTypedThereDoNothingElse) {
  open({"--paused", "--seed", "1"});
  screen_.press("Right");
  await("step 1");
  click("seed");
  await("text on");
  type("77");
  EXPECT_EQ(await("value seed "), "77");
  EXPECT_EQ(await("step "), "0") << "a new seed is a new litter";
  click("new_seed");
  EXPECT_NE(await("value seed "), "77");
}

TEST_F(Live, AParameterOfTheLitterRestartsIt) {
  open({"--paused"});
  screen_.press("Right");
  await("step 1");
  type_into_slider("pups", "250");  // beyond the slider's end, within what is allowed
  EXPECT_EQ(await("value pups "), "250");
  EXPECT_EQ(await("step "), "0");
}

TEST_F(Live, ValuesThatAreNotAllowedAreNotTaken) {
  open({"--paused"});
  type_into_slider("alpha", "7");
  type_into_slider("beta", "0.25");
  while (true) {
    const std::string value = await("value ");
    EXPECT_THAT(value, Not(StartsWith("alpha")));
    if (value == "beta 0.25") break;
  }
}

TEST_F(Live, ABadStateSaysWhereAndWaitsForARestart) {
  open({"--set", "heat=euler", "--set", "k1=210", "--set", "pups=2"});
  const std::string message = await("bad ");
  EXPECT_THAT(message, HasSubstr("diverged at step"));
  EXPECT_THAT(message, HasSubstr("pup"));
  click("bad_restart");
  await("state playing");  // it ran, so it runs again
}

TEST_F(Live, AWarningIsShownAndTheLitterGoesOn) {
  open({"--set", "drive=60", "--set", "pups=3"});
  screen_.press("f");
  EXPECT_THAT(await("warning "), HasSubstr("outside the wall from step "));
  EXPECT_THAT(await("warning "), HasSubstr("hanging in the air from step "));
  await("step ");
}

TEST_F(Live, TheMouseTurnsTheViewAndHomeTurnsItBack) {
  open({"--paused"});
  const int x = 700, y = 450;  // in the arena
  screen_.press_and_move(x, y, x + 80, y);
  std::string turned;
  while (turned.empty() || turned.starts_with("0.523")) turned = await("camera ");
  screen_.release();
  screen_.press("Home");
  std::string camera = turned;
  while (!camera.starts_with("0.523")) camera = await("camera ");  // 30 degrees
}

TEST_F(Live, AViewThatTurnsHasOneSampleAPixelAndAllAfterRest) {
  open({"--paused", "--supersample", "3"});
  EXPECT_EQ(await("samples "), "1");
  EXPECT_EQ(await("samples "), "3");
  screen_.press_and_move(700, 450, 780, 450);
  EXPECT_EQ(await("samples "), "1");
  screen_.release();
  EXPECT_EQ(await("samples "), "3");
}

TEST_F(Live, APausedWindowAtRestDrawsNoFrames) {
  open({"--paused", "--exit-after", "4"});
  EXPECT_LT(std::stoi(await("frames ")), 20) << "first frames, layout, sharp frame";
  EXPECT_EQ(exit_code(), 0);
}

TEST_F(Live, CtrlCEndsItWithItsOwnCode) {
  open();
  window_->send_signal(SIGINT);
  EXPECT_EQ(exit_code(), 130) << window_->errors();
}

TEST_F(Live, ClosesByItselfWhenAsked) {
  open({"--exit-after", "1"});
  EXPECT_EQ(exit_code(), 0);
}

TEST(LiveWithoutDisplay, SaysSoAndWhatWouldWork) {
  Child program({.arguments = {PUPFLOW_PROGRAM, "live"},
                 .environment = {"DISPLAY", "WAYLAND_DISPLAY"},
                 .folder = {}});
  EXPECT_EQ(program.wait().value_or(-1), 5);
  EXPECT_THAT(program.errors(), HasSubstr("DISPLAY"));
  EXPECT_THAT(program.errors(), HasSubstr("pupflow render"));
}

}  // namespace
}  // namespace pupflow::testing
