#include "app/window/key_map.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <tuple>

namespace pupflow::window {
namespace {

constexpr int kLast = static_cast<int>(Action::quit);

int mods_of(const KeyRow& row) {
  return (row.shift ? GLFW_MOD_SHIFT : 0) | (row.ctrl ? GLFW_MOD_CONTROL : 0);
}

TEST(KeyMap, EveryKeyOfTheTableDoesWhatItsRowSays) {
  for (const KeyRow& row : key_table()) {
    for (const int key : row.keys) {
      if (key == 0) continue;
      EXPECT_EQ(action_for(key, mods_of(row), false), row.action) << row.text;
    }
  }
}

TEST(KeyMap, EveryActionHasAKeyAndNoKeyTwoActions) {
  std::set<int> actions;
  std::set<std::tuple<int, int>> strokes;
  for (const KeyRow& row : key_table()) {
    actions.insert(static_cast<int>(row.action));
    for (const int key : row.keys) {
      if (key == 0) continue;
      EXPECT_TRUE(strokes.insert({key, mods_of(row)}).second) << row.text;
    }
  }
  EXPECT_EQ(actions.size(), static_cast<std::size_t>(kLast + 1));
}

TEST(KeyMap, TheHelpNamesTheLettersThatWork) {
  for (const KeyRow& row : key_table()) {
    EXPECT_NE(std::string(row.doc), "");
    for (const int key : row.keys) {
      if (key < 128 && std::isalpha(key) != 0) {
        EXPECT_THAT(row.text, testing::HasSubstr(std::string(1, static_cast<char>(key))));
      }
    }
  }
}

TEST(KeyMap, TheHelpSaysShiftForEachKeyThatNeedsIt) {
  for (const KeyRow& row : key_table()) {
    const std::string_view text = row.text;
    const auto keys = std::count_if(row.keys.begin(), row.keys.end(), [](int k) { return k != 0; });
    std::ptrdiff_t shifts = 0;
    for (std::size_t at = text.find("Shift"); at != text.npos; at = text.find("Shift", at + 1)) {
      ++shifts;
    }
    EXPECT_EQ(shifts, row.shift ? keys : 0) << text;
  }
}

TEST(KeyMap, TheWellKnownKeys) {
  EXPECT_EQ(action_for(GLFW_KEY_SPACE, 0, false), Action::play_pause);
  EXPECT_EQ(action_for(GLFW_KEY_RIGHT, 0, false), Action::step);
  EXPECT_EQ(action_for(GLFW_KEY_R, 0, false), Action::restart);
  EXPECT_EQ(action_for(GLFW_KEY_F12, 0, false), Action::screenshot);
  EXPECT_EQ(action_for(GLFW_KEY_F1, 0, false), Action::toggle_help);
  EXPECT_EQ(action_for(GLFW_KEY_ESCAPE, 0, false), Action::close);
  EXPECT_EQ(action_for(GLFW_KEY_Q, 0, false), Action::quit);
}

TEST(KeyMap, ShiftChoosesItsOwnRowAndIsOtherwiseIgnored) {
  EXPECT_EQ(action_for(GLFW_KEY_N, GLFW_MOD_SHIFT, false), Action::step_many);
  EXPECT_EQ(action_for(GLFW_KEY_EQUAL, GLFW_MOD_SHIFT, false), Action::faster);
  EXPECT_EQ(action_for(GLFW_KEY_S, GLFW_MOD_SHIFT, false), Action::screenshot);
}

TEST(KeyMap, CtrlHasRowsOfItsOwn) {
  EXPECT_EQ(action_for(GLFW_KEY_Z, GLFW_MOD_CONTROL, false), Action::undo);
  EXPECT_EQ(action_for(GLFW_KEY_Z, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT, false), Action::redo);
  EXPECT_EQ(action_for(GLFW_KEY_Y, GLFW_MOD_CONTROL, false), Action::redo);
  EXPECT_EQ(action_for(GLFW_KEY_Y, 0, false), Action::side_view);
  EXPECT_FALSE(action_for(GLFW_KEY_Z, 0, false));
  EXPECT_FALSE(action_for(GLFW_KEY_T, GLFW_MOD_CONTROL, false));
}

TEST(KeyMap, TheHelpSaysCtrlWhereItIsNeeded) {
  for (const KeyRow& row : key_table()) {
    EXPECT_EQ(std::string_view(row.text).find("Ctrl") != std::string_view::npos, row.ctrl);
  }
}

TEST(KeyMap, OtherModifiersAndOtherKeysDoNothing) {
  for (const int mod : {GLFW_MOD_CONTROL, GLFW_MOD_ALT, GLFW_MOD_SUPER}) {
    EXPECT_FALSE(action_for(GLFW_KEY_Q, mod, false));
  }
  EXPECT_FALSE(action_for(GLFW_KEY_F7, 0, false));
  EXPECT_FALSE(action_for(0, 0, false));
}

TEST(KeyMap, AHeldKeyRepeatsOnlyWhereThatHelps) {
  EXPECT_EQ(action_for(GLFW_KEY_RIGHT, 0, true), Action::step);
  EXPECT_FALSE(action_for(GLFW_KEY_SPACE, 0, true));
  EXPECT_FALSE(action_for(GLFW_KEY_S, 0, true));
}

}  // namespace
}  // namespace pupflow::window
