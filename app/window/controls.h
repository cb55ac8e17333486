// What the panels and keys act on.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/look.h"
#include "app/window/key_map.h"
#include "app/window/session/session.h"

namespace pupflow::window {

/// How the camera goes with the selected pup.
enum class CameraMode {
  free,    // it stays where it is
  follow,  // the pup stays in the middle
  eye      // it looks along the pup's heading, from in front of its body
};

/// Steps of a run, the first and the last.
struct StepRange {
  std::int64_t first, last;
};

/// The window's own state beside the simulation's, and what was asked for since the last frame.
struct Controls {
  Params params;         // the window's copy: always sound, sent whole with every edit
  Params seen;           // those of the last snapshot
  double speed = 1;      // times real time, unless
  bool as_fast = false;  // as fast as possible
  pictures::Look look;
  std::optional<std::int64_t> typed_seed;     // while it is being typed
  std::optional<int> selected;                // a pup, by its number
  CameraMode camera_mode = CameraMode::free;  // others than free only while a pup is selected
  bool panels = true;
  bool help = false;
  std::string problem;  // why the last value was not taken; empty when it was

  std::string message;                // to be shown over the arena for a while
  std::optional<StepRange> save_csv;  // steps to be saved as CSV

  std::vector<Command> commands;  // for the runner
  std::vector<Action> actions;    // as if their keys had been pressed

  /// Makes `candidate` the parameters and asks the runner to take them, if it is sound; otherwise
  /// says why in `problem`.
  void propose(const Params& candidate);

  /// Takes over what the schedule has changed since the last snapshot.
  void follow(const Params& in_force, const Schedule& schedule);

  /// Shows another field in colors, with the usual color map and range of its kind.
  void color_by(const LitterField& field);

  /// The slider range of `speed`.
  static constexpr double kSlowest = 1.0 / 16, kFastest = 64;

  /// Asks for this speed, kept within kSlowest ... kFastest.
  void set_speed(double factor);
  void set_as_fast(bool on);
};

}  // namespace pupflow::window
