// A run of a litter: all that is needed to come back to any of its steps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/window/session/history.h"
#include "app/window/session/keyframes.h"
#include "app/window/session/timeline.h"
#include "pupflow/simulation.h"

namespace pupflow::window {

struct Run {
  struct Mark : Timeline::Mark {
    std::optional<std::size_t> ramped = {};  // the parameter of a ramp, its place in parameters()
  };

  Params recipe;                         // of the start, with all that has changed since
  std::shared_ptr<const Snapshot> from;  // where it began; none: at a new litter
  std::int64_t last = 0;                 // the furthest step so far
  Keyframes keyframes = {};
  History history = {};
  std::vector<Mark> marks = {};                  // by step
  std::vector<Warning> warnings = {};            // by step
  std::optional<std::int64_t> diverged_at = {};  // compared with another one

  std::int64_t first() const { return from ? from->step : 0; }

  /// The litter at the last step, at or before `step`, that is kept. It goes on as the recipe says.
  Simulation kept_at(std::int64_t step) const;

  /// Forgets what came after `step`, but for the recipe.
  void cut(std::int64_t step);

  /// Adds a mark behind those of the same step.
  void add(Mark mark);

  /// Somebody sets a parameter at `step`: a ramp of it that goes on then has ended.
  void end_ramps(std::size_t parameter, std::int64_t step);
};

}  // namespace pupflow::window
