// What the window shows of a run so far.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pupflow::window {

/// A run so far, which can be gone back to.
struct Timeline {
  enum class Kind { edit, ramp, pull, bad };
  struct Mark {
    std::int64_t step;
    std::optional<std::int64_t> until;  // of ramps and pulls
    Kind kind;
    std::string text;  // what was done, as people read it: "T_a 0.4 \u2192 0.2"
  };

  std::int64_t first = 0, last = 0;  // the steps that can be gone to
  std::vector<Mark> marks;           // by step
  // The future that was left for an edit in the past: where it parts from this run, and its end.
  std::optional<std::int64_t> parted_at;
  std::int64_t other_last = 0;
  bool can_undo = false, can_redo = false;
};

}  // namespace pupflow::window
