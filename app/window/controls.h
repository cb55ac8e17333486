// What the panels and keys act on.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/look.h"
#include "app/window/key_map.h"
#include "app/window/picture_size.h"
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
  Params params;              // the window's copy: always sound, sent whole with every edit
  Params seen;                // those of the last snapshot
  std::int64_t refusals = 0;  // of edits, by the last snapshot
  Params scene;               // what the run was opened with
  double speed = 1;           // times real time, unless
  bool as_fast = false;       // as fast as possible
  pictures::Look look;
  std::optional<int> selected;                // a pup, by its number
  CameraMode camera_mode = CameraMode::free;  // others than free only while a pup is selected
  Watch inspected;               // what the inspector shows; nothing while it is closed
  Watch watched;                 // what the runner was asked to record
  bool panels = true;            // beside the arena
  bool drawer = false;           // the panel over the arena, in a window that is
  bool narrow = false;           // too narrow for panels beside it
  bool colors_in_strip = false;  // the lists of the colors stand beside the arena
  bool help = false;
  PictureSize picture_size;              // of pictures and films
  PixelSize seen_size;                   // of the arena with its legend
  std::optional<double> filmed;          // seconds of the film so far, while there is one
  std::vector<std::string> recent;       // files, the last one first
  std::string open;                      // a shipped scene or a file to open now; empty: none
  bool pause_minimised = false;          // a minimised window takes no steps
  std::optional<std::int64_t> going_to;  // the step that GoTo asked for, until it is reached
  std::int64_t goings = 0;               // times that GoTo was asked for
  std::string problem;                   // why the last value was not taken; empty when it was
  std::string problem_at;                // the parameter or field that it is about

  std::string message;                // to be shown over the arena for a while
  std::optional<StepRange> save_csv;  // steps to be saved as CSV

  double wake_in = 0;  // seconds after which a frame is needed; 0: never

  std::vector<Command> commands;  // for the runner
  std::vector<Action> actions;    // as if their keys had been pressed

  /// Makes `candidate` the parameters and asks the runner to take them, if it is sound; otherwise
  /// says why in `problem`. `continues`: undo takes it back together with the edit before.
  void propose(const Params& candidate, bool continues = false);

  /// The same with one parameter changed.
  void propose(const Parameter& parameter, double value, bool continues = false);

  /// Says why what was typed into a field was not taken.
  void refuse(std::string_view field, std::string reason);

  /// Takes over the parameters that have changed since the last snapshot: by the schedule, by undo,
  /// by going back.
  void follow(const LiveState& state);

  /// Asks for that step of the run, kept within the steps that can be gone to.
  void go_to(std::int64_t step, const Timeline& timeline);

  /// The step that is shown, or that was asked for and is still to come.
  std::int64_t shown_step(const LiveState& state) const;

  /// Selects another pup, or none; none ends its camera.
  void select(std::optional<int> pup);

  /// Selects a pup and brings it into the middle of the arena.
  void show(int pup);

  /// Has steps record what the overlays and the inspector show, when that has changed.
  void watch();

  /// Shows another field in colors, with the usual color map and range of its kind.
  void color_by(const LitterField& field);

  /// The speeds that can be asked for, and those that a slider and the keys reach.
  static constexpr double kLeastSpeed = 0.001, kGreatestSpeed = 1e6;
  static constexpr double kSlowest = 1.0 / 16, kFastest = 64;

  /// Asks for this speed, which must be within kLeastSpeed ... kGreatestSpeed.
  void set_speed(double factor);

  /// Twice the speed, or half of it, as far as the slider goes.
  void faster();
  void slower();
  void set_as_fast(bool on);
};

}  // namespace pupflow::window
