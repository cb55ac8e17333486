// What the live window is asked for.
#pragma once

#include <optional>
#include <string>

#include "app/pictures/look.h"
#include "pupflow/snapshot.h"

namespace pupflow::window {

/// `pupflow live`: the window.
struct LiveJob {
  Params params;                 // the recipe
  std::optional<Snapshot> from;  // a litter of that recipe to begin with; none: a new one
  pictures::Look look;
  int width = 1400, height = 900;
  int threads = 1;           // that share a step
  double ui_scale = 0;       // 0: the display's
  bool paused = false;       // start paused
  std::string screenshot;    // pattern for screenshots, with %d for the step
  bool test_events = false;  // print widget rectangles and value changes, for window tests
  double exit_after = 0;     // close by itself after so many seconds; 0: never
};

}  // namespace pupflow::window
