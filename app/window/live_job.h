// What the live window is asked for.
#pragma once

#include <optional>
#include <string>

#include "app/pictures/look.h"
#include "pupflow/snapshot.h"

namespace pupflow::window {

constexpr int kUsualWidth = 1400, kUsualHeight = 900;
constexpr double kSmallestScale = 0.5, kLargestScale = 4;  // of text and widgets

/// `pupflow live`: the window.
struct LiveJob {
  /// Which of these were typed: the others take what the user's settings say.
  struct Given {
    bool size = false, ui_scale = false, quality = false, draw = false, colormap = false;
  };

  Params params;                 // the recipe
  std::optional<Snapshot> from;  // a litter of that recipe to begin with; none: a new one
  std::string opened;            // the scene or file that brought it; empty: neither
  pictures::Look look;
  Given given;
  int width = kUsualWidth, height = kUsualHeight;
  int threads = 1;           // that share a step
  double ui_scale = 0;       // 0: the display's
  bool paused = false;       // start paused
  std::string screenshot;    // pattern for screenshots, with %d for the step
  bool test_events = false;  // print widget rectangles and value changes, for window tests
  double exit_after = 0;     // close by itself after so many seconds; 0: never
};

}  // namespace pupflow::window
