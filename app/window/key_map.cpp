#include "app/window/key_map.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>

namespace pupflow::window {
namespace {

constexpr std::array kKeys{
    KeyRow{Action::play_pause, {GLFW_KEY_SPACE}, false, false, "Space", "play or pause"},
    KeyRow{Action::step_many,
           {GLFW_KEY_RIGHT, GLFW_KEY_N},
           true,
           true,
           "Shift + Right, Shift + N",
           "pause and make 100 steps"},
    KeyRow{Action::step,
           {GLFW_KEY_RIGHT, GLFW_KEY_N},
           false,
           true,
           "Right, N",
           "pause and make one step"},
    KeyRow{Action::step_back_many,
           {GLFW_KEY_LEFT},
           true,
           true,
           "Shift + Left",
           "pause and go 100 steps back"},
    KeyRow{Action::step_back, {GLFW_KEY_LEFT}, false, true, "Left", "pause and go one step back"},
    KeyRow{Action::to_start,
           {GLFW_KEY_LEFT},
           false,
           false,
           "Ctrl + Left",
           "pause and go to the start of the run",
           true},
    KeyRow{Action::to_end,
           {GLFW_KEY_RIGHT},
           false,
           false,
           "Ctrl + Right",
           "pause and go to the last step made",
           true},
    KeyRow{Action::restart, {GLFW_KEY_R}, false, false, "R", "start again with the same seed"},
    KeyRow{Action::new_seed, {GLFW_KEY_R}, true, false, "Shift + R", "start again with a new seed"},
    KeyRow{Action::undo,
           {GLFW_KEY_Z},
           false,
           true,
           "Ctrl + Z",
           "undo the last change of a parameter",
           true},
    KeyRow{Action::redo, {GLFW_KEY_Z}, true, true, "Ctrl + Shift + Z", "redo it", true},
    KeyRow{Action::redo, {GLFW_KEY_Y}, false, true, "Ctrl + Y", "redo it", true},
    KeyRow{Action::faster, {'+', GLFW_KEY_EQUAL, GLFW_KEY_KP_ADD}, false, true, "+", "faster"},
    KeyRow{Action::slower, {'-', GLFW_KEY_KP_SUBTRACT}, false, true, "-", "slower"},
    KeyRow{Action::real_time, {GLFW_KEY_1, GLFW_KEY_KP_1}, false, false, "1", "real time"},
    KeyRow{Action::as_fast_as_possible, {GLFW_KEY_F}, false, false, "F", "as fast as possible"},
    KeyRow{Action::reset_camera,
           {GLFW_KEY_HOME, GLFW_KEY_C},
           false,
           false,
           "Home, C",
           "reset the view"},
    KeyRow{Action::top_view, {GLFW_KEY_T}, false, false, "T", "look from above"},
    KeyRow{Action::side_view, {GLFW_KEY_Y}, false, false, "Y", "look from the side"},
    KeyRow{
        Action::previous_pup, {GLFW_KEY_TAB}, true, true, "Shift + Tab", "select the pup before"},
    KeyRow{Action::next_pup, {GLFW_KEY_TAB}, false, true, "Tab", "select the next pup"},
    KeyRow{Action::follow_pup, {GLFW_KEY_L}, false, false, "L", "follow the selected pup, or stop"},
    KeyRow{Action::pups_eye,
           {GLFW_KEY_E},
           false,
           false,
           "E",
           "look out of the selected pup's eyes, or stop"},
    KeyRow{Action::screenshot,
           {GLFW_KEY_S, GLFW_KEY_F12},
           false,
           false,
           "S, F12",
           "save a picture (PNG, with all parameters in it)"},
    KeyRow{Action::record, {GLFW_KEY_V}, false, false, "V", "begin or end a film (MP4)"},
    KeyRow{Action::open,
           {GLFW_KEY_O},
           false,
           false,
           "Ctrl + O",
           "open a scene, a checkpoint, or any file with a recipe",
           true},
    KeyRow{Action::save, {GLFW_KEY_S}, false, false, "Ctrl + S", "save the scene", true},
    KeyRow{Action::save_as,
           {GLFW_KEY_S},
           true,
           false,
           "Ctrl + Shift + S",
           "save the scene under another name",
           true},
    KeyRow{Action::copy_command,
           {GLFW_KEY_C},
           false,
           false,
           "Ctrl + C",
           "copy the command that repeats the run up to here",
           true},
    KeyRow{Action::larger,
           {'+', GLFW_KEY_EQUAL, GLFW_KEY_KP_ADD},
           false,
           true,
           "Ctrl + +",
           "larger text",
           true},
    KeyRow{Action::smaller,
           {'-', GLFW_KEY_KP_SUBTRACT},
           false,
           true,
           "Ctrl + -",
           "smaller text",
           true},
    KeyRow{Action::usual_size,
           {GLFW_KEY_0, GLFW_KEY_KP_0},
           false,
           false,
           "Ctrl + 0",
           "text of the display's size",
           true},
    KeyRow{Action::switch_theme, {GLFW_KEY_D}, false, false, "Ctrl + D", "light or dark", true},
    KeyRow{Action::full_screen, {GLFW_KEY_F11}, false, false, "F11", "full screen, or not"},
    KeyRow{Action::toggle_panels, {GLFW_KEY_H}, false, false, "H", "hide or show the panels"},
    KeyRow{Action::toggle_help, {GLFW_KEY_F1}, false, false, "F1", "open or close this help"},
    KeyRow{Action::work_panels,
           {GLFW_KEY_F6},
           false,
           false,
           "F6",
           "work the next panel by keys: arrows, Space, Enter"},
    KeyRow{Action::close,
           {GLFW_KEY_ESCAPE},
           false,
           true,
           "Esc",
           "close what is open, then leave the pup, then select none"},
    KeyRow{Action::quit, {GLFW_KEY_Q}, false, false, "Q", "quit"},
};

constexpr std::array kMouse{
    MouseRow{"Left drag", "turn the view"},
    MouseRow{"Click on a pup", "select it"},
    MouseRow{"Double click on a pup", "follow it"},
    MouseRow{"Ctrl + left drag on a pup", "pull it"},
    MouseRow{"Right or middle drag, Shift + left drag", "move the view"},
    MouseRow{"Wheel", "nearer or further, towards the cursor"},
    MouseRow{"Minimise the window", "the run goes on, unless Run > pause when minimised"},
    MouseRow{"Click on a number, double click or Ctrl + click on its slider",
             "type it, also beyond the slider's ends; a comma is a decimal point"},
    MouseRow{"Right click on a parameter, or click on its title",
             "its default, the scene's value, a ramp"},
    MouseRow{"Drag on the timeline", "go to any step of the run"},
};

}  // namespace

std::span<const KeyRow> key_table() {
  return kKeys;
}

const KeyRow& key_row(Action action) {
  return *std::find_if(kKeys.begin(), kKeys.end(),
                       [&](const KeyRow& row) { return row.action == action; });
}

std::span<const MouseRow> mouse_table() {
  return kMouse;
}

std::optional<Action> action_for(int key, int mods, bool repeated) {
  if (key == 0 || (mods & (GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0) return {};
  const bool ctrl = (mods & GLFW_MOD_CONTROL) != 0;
  const auto row_with = [&](bool shift) {
    return std::find_if(kKeys.begin(), kKeys.end(), [&](const KeyRow& row) {
      return row.ctrl == ctrl && row.shift == shift &&
             std::count(row.keys.begin(), row.keys.end(), key) > 0;
    });
  };
  auto row = kKeys.end();
  if ((mods & GLFW_MOD_SHIFT) != 0) row = row_with(true);
  if (row == kKeys.end()) row = row_with(false);
  if (row == kKeys.end() || (repeated && !row->repeats)) return {};
  return row->action;
}

int layout_key(int key, int scancode) {
  const char* name = glfwGetKeyName(key, scancode);
  if (name == nullptr || name[0] == '\0' || name[1] != '\0') return key;
  return std::toupper(static_cast<unsigned char>(name[0]));
}

}  // namespace pupflow::window
