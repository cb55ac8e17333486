// The keys, once: this table both dispatches and prints the help.
#pragma once

#include <array>
#include <optional>
#include <span>

namespace pupflow::window {

enum class Action {
  play_pause,
  step,
  step_many,
  step_back,
  step_back_many,
  to_start,
  to_end,
  restart,
  new_seed,
  undo,
  redo,
  faster,
  slower,
  real_time,
  as_fast_as_possible,
  reset_camera,
  top_view,
  side_view,
  next_pup,
  previous_pup,
  follow_pup,
  pups_eye,
  screenshot,
  record,
  open,
  save,
  save_as,
  copy_command,
  larger,
  smaller,
  usual_size,
  switch_theme,
  full_screen,
  toggle_panels,
  toggle_help,
  work_panels,
  close,
  quit
};

/// How far Action::step_many and Action::step_back_many go.
constexpr int kManySteps = 100;

/// One row: any of `keys` does `action`. Keys are GLFW's codes, for printing keys the capital
/// letter or sign itself; 0 fills up.
struct KeyRow {
  Action action;
  std::array<int, 3> keys;
  bool shift;        // only with Shift held
  bool repeats;      // again while held
  const char* text;  // the keys as help prints them
  const char* doc;
  bool ctrl = false;  // only with Ctrl held
};

std::span<const KeyRow> key_table();

/// The row of an action.
const KeyRow& key_row(Action action);

/// What pressing `key` with GLFW's modifier bits `mods` does; nothing with Alt or Super. Rows with
/// Shift come before those without, and Shift is otherwise ignored (it may be what types '+').
/// `repeated`: the key is being held.
std::optional<Action> action_for(int key, int mods, bool repeated);

/// The table's code for a key that GLFW reports: on any keyboard layout what is printed on it.
int layout_key(int key, int scancode);

/// What the mouse does over the arena; for the help.
struct MouseRow {
  const char* text;
  const char* doc;
};
std::span<const MouseRow> mouse_table();

}  // namespace pupflow::window
