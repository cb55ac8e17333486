// Numbers typed, menus of parameters, presets, timeline, undo: with a real mouse and keyboard.
#include <gmock/gmock.h>

#include <sstream>

#include "app/io/scene_file.h"
#include "app/io/text.h"
#include "tests/window/live_fixture.h"

namespace pupflow::testing {
namespace {

using ::testing::HasSubstr;

class LiveControls : public Live {
 protected:
  void right_click(const std::string& name) {
    const Box box = widget(name);
    screen_.hand({"mousemove", std::to_string(box.middle_x()), std::to_string(box.middle_y()),
                  "sleep", "0.1", "click", "3"});
  }

  /// Types into a field of the panel.
  void type_into(const std::string& name, const std::string& text) {
    click(name);
    await("text on");
    type(text);
  }

  /// Presses on the timeline at a share of its width.
  void press_timeline(double share) {
    const Box box = widget("timeline");
    screen_.click(box.x + static_cast<int>(share * box.width), box.middle_y());
  }

  /// The step and the hash of the next line that says one.
  std::pair<std::int64_t, std::string> next_hash() {
    std::istringstream words(await("hash "));
    std::pair<std::int64_t, std::string> said;
    words >> said.first >> said.second;
    return said;
  }

  void await_hash_of(const Params& params, std::int64_t step) {
    EXPECT_EQ(await("hash " + std::to_string(step) + ' '), headless_hash(params, step));
  }
};

TEST_F(LiveControls, ACommaIsADecimalPointAndAllDigitsAreKept) {
  open({"--paused"});
  type_into("ta-field", "0,25");
  EXPECT_EQ(await("value ta "), "0.25");
  type_into("ta-field", "0.12345678901234567");
  EXPECT_EQ(await("value ta "), io::number_text(0.12345678901234567));
  type_into("gravity-field", "123.5");
  EXPECT_EQ(await("value gravity "), "123.5") << "beyond the slider's end";
}

TEST_F(LiveControls, WhatIsNotTakenSaysWhyAndNothingMoves) {
  open({"--paused"});
  type_into("alpha-field", "x");  // the window has its final layout by then
  EXPECT_THAT(await("problem alpha "), HasSubstr("'x'"));
  const auto before = widgets();
  for (const char* text : {"abc", "1e400", "7"}) {
    type_into("alpha-field", text);
    EXPECT_THAT(await("problem alpha "), HasSubstr(text));
  }
  for (const auto& [name, widget] : before) {
    EXPECT_EQ(widgets().at(name).box.x, widget.box.x) << name;
    EXPECT_EQ(widgets().at(name).box.y, widget.box.y) << name;
  }
  type_into("alpha-field", "0.5");
  EXPECT_EQ(await("problem"), "") << "it is gone";
  EXPECT_EQ(await("value alpha "), "0.5");
}

TEST_F(LiveControls, ADoubleClickOnASliderTypesAndChangesNothingElse) {
  open({"--paused"});
  const auto double_click = [&](const std::string& name) {
    const Box box = widget(name);
    screen_.hand({"mousemove", std::to_string(box.x + 9 * box.width / 10),
                  std::to_string(box.middle_y()), "sleep", "0.1", "click", "--repeat", "2",
                  "--delay", "120", "1"});  // not in one frame
    await("text on");
  };
  double_click("ta");
  screen_.press("Escape");
  await("text off");
  settle();
  screen_.press("ctrl+c");
  EXPECT_THAT(await("copied "), ::testing::Not(HasSubstr("ta=")))
      << "what the first click moved is back";
  double_click("ta");
  type("0.31");
  while (await("value ta ") != "0.31") {
  }
  double_click("pups");
  type("3");
  EXPECT_EQ(await("value pups "), "3") << "no other litter was there before";
}

TEST_F(LiveControls, EscapeLeavesTheValueThatWasThere) {
  open({"--paused"});
  click("ta-field");
  await("text on");
  screen_.hand({"type", "--delay", "60", "0.9"});
  screen_.press("Escape");
  await("text off");
  type_into("beta-field", "0.75");
  EXPECT_EQ(await("value "), "beta 0.75");
}

TEST_F(LiveControls, ASpeedIsTakenAsTypedOrRefused) {
  open({"--paused"});
  type_into("speed-field", "1000");
  EXPECT_EQ(await("speed "), "1000");
  type_into("speed-field", "0");
  EXPECT_THAT(await("problem speed "), HasSubstr("0.001"));
  type_into("speed-field", "0,5");
  EXPECT_EQ(await("speed "), "0.5");
}

TEST_F(LiveControls, ASeedThatIsNoNumberIsRefused) {
  open({"--paused", "--seed", "1"});
  type_into("seed", "77q");
  EXPECT_THAT(await("problem seed "), HasSubstr("77q"));
  type_into("seed", "77");
  EXPECT_EQ(await("value seed "), "77");
}

TEST_F(LiveControls, ARightClickOffersTheSceneAndTheDefault) {
  open({"--paused", "--set", "ta=0.3"});
  type_into("ta-field", "0.8");
  await("value ta 0.8");
  right_click("ta");
  click("ta-scene");
  EXPECT_EQ(await("value ta "), "0.3");
  click("ta-menu");             // the title opens it too
  await("widget ta-default ");  // elsewhere
  click("ta-default");
  EXPECT_EQ(await("value ta "), "0.4");
  right_click("ta");
  await("widget ta-type ");
  click("ta-type");
  await("text on");
  type("0.55");
  EXPECT_EQ(await("value ta "), "0.55");
}

TEST_F(LiveControls, PresetsAreThoseOfTheShippedScenes) {
  open({"--paused"});
  for (const std::string name : {"cold", "critical", "warm"}) {
    std::vector<std::string> problems;
    const io::Scene scene = io::load_scene(name, problems);
    click("preset-" + scene.title);
    EXPECT_EQ(await("value ta "),
              format_value(*find_parameter("ta"), scene.params.ambient_temperature));
  }
}

TEST_F(LiveControls, ResetsGoToTheSceneAndToThePaper) {
  open({"--paused", "--set", "ta=0.2"});
  type_into("alpha-field", "0.25");
  await("value alpha 0.25");
  click("reset-scene");
  EXPECT_EQ(await("value "), "alpha 0.7") << "T_a stays that of the scene";
  click("reset-paper");
  EXPECT_EQ(await("value "), "ta 0.4");
}

TEST_F(LiveControls, ADraggedPlayheadShowsExactlyWhatWasThereThen) {
  open({"--paused", "--seed", "6"});
  Params params;
  params.seed = 6;
  screen_.press("shift+Right");
  await_hash_of(params, 100);
  const Box box = widget("timeline");
  screen_.press_and_move(box.x + box.width - 2, box.middle_y(), box.x + box.width / 3,
                         box.middle_y());
  screen_.release();
  std::int64_t step = 100;
  while (step > 36) {
    const auto [at, hash] = next_hash();
    EXPECT_EQ(hash, headless_hash(params, at));
    step = at;
  }
  press_timeline(0);
  await_hash_of(params, 0);
}

TEST_F(LiveControls, KeysGoBackAndToBothEnds) {
  open({"--paused"});
  screen_.press("shift+Right");
  await_hash_of(Params{}, 100);
  screen_.press("Left");
  await_hash_of(Params{}, 99);
  screen_.press("ctrl+Left");
  await_hash_of(Params{}, 0);
  screen_.press("ctrl+Right");
  await_hash_of(Params{}, 100);
  screen_.press("shift+Left");
  await_hash_of(Params{}, 0);
  screen_.press("Right");
  await_hash_of(Params{}, 1);
  click("step_back");
  await_hash_of(Params{}, 0);
}

TEST_F(LiveControls, UndoAndRedoByKeyAndByMenu) {
  open({"--paused"});
  type_into("ta-field", "0.2");
  await("value ta 0.2");
  screen_.press("ctrl+z");
  EXPECT_EQ(await("value ta "), "0.4");
  screen_.press("ctrl+shift+z");
  EXPECT_EQ(await("value ta "), "0.2");
  screen_.press("ctrl+z");
  EXPECT_EQ(await("value ta "), "0.4");
  screen_.press("ctrl+y");
  EXPECT_EQ(await("value ta "), "0.2");
  type_into("ta-field", "0.3");
  EXPECT_EQ(await("value ta "), "0.3") << "the field follows what undo does";
}

TEST_F(LiveControls, ADragIsUndoneAsAWhole) {
  open({"--paused", "--set", "ta=0.4"});
  const Box box = widget("ta");
  screen_.press_and_move(box.x + 2 * box.width / 5, box.middle_y(), box.x + 4 * box.width / 5,
                         box.middle_y());
  screen_.release();
  double ta = 0.4;
  while (ta < 0.75) ta = std::stod(await("value ta "));
  screen_.press("ctrl+z");
  std::string value;
  while (value != "0.4") value = await("value ta ");
}

TEST_F(LiveControls, ARampByItsMenuEndsWhereItShould) {
  open({"--paused", "--set", "ta=0.4"});
  click("ta-menu");
  click("ta-ramp-to");
  await("text on");
  type("0,2");
  click("ta-ramp-seconds");
  await("text on");
  type("0.5");
  click("ta-ramp-start");
  screen_.press("shift+Right");
  EXPECT_NE(await("hash 100 "), headless_hash(Params{}, 100));
  std::string value;
  Params ramped;
  const auto ta = static_cast<std::size_t>(find_parameter("ta") - parameters().data());
  Change change;
  change.until = 50;
  change.settings = {{ta, 0.2}};
  ramped.schedule.add(change);
  screen_.press("Left");
  await_hash_of(ramped, 99);
}

TEST_F(LiveControls, AnotherFutureIsKeptAndReturnedTo) {
  open({"--paused"});
  screen_.press("shift+Right");
  await_hash_of(Params{}, 100);
  press_timeline(0);
  await_hash_of(Params{}, 0);
  type_into("ta-field", "0.2");
  await("value ta 0.2");
  screen_.press("Right");
  await("step 1");
  click("swap-future");
  EXPECT_EQ(await("value ta "), "0.4");
  screen_.press("ctrl+Right");
  await_hash_of(Params{}, 100);
}

TEST_F(LiveControls, AComparisonIsBegunAndEnded) {
  open({"--paused"});
  click("compare");
  click("compare-value");
  await("text on");
  type("0.1");
  click("compare-start");
  EXPECT_EQ(await("second "), "T_a 0.4 \u2192 0.1");
  click("compare");
  click("compare-end");
  EXPECT_EQ(await("second "), "none");
}

TEST_F(LiveControls, AMarkOnTheTimelineSaysWhatWasDoneThere) {
  open({"--paused", "--set", "ta=0.5"});
  screen_.press("shift+n");
  await("hash 100 ");
  type_into("ta-field", "0.2345");
  await("value ta 0.2345");
  screen_.press("shift+n");
  await("hash 200 ");
  const Box box = widget("timeline");
  constexpr int kStops = 120;
  std::vector<std::string> sweep;
  for (int i = 0; i <= kStops; ++i) {
    sweep.insert(sweep.end(), {"mousemove", std::to_string(box.x + i * (box.width - 1) / kStops),
                               std::to_string(box.middle_y()), "sleep", "0.01"});
  }
  screen_.hand(sweep);
  const std::string said = await("mark step ");
  EXPECT_THAT(said, ::testing::StartsWith("100, "));
  EXPECT_THAT(said, HasSubstr("0.2345"));
  await("mark none");
}

}  // namespace
}  // namespace pupflow::testing
