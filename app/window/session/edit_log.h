// What can be undone and done again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "app/window/session/parameter_text.h"
#include "pupflow/snapshot.h"

namespace pupflow::window {

/// One thing that the user did.
struct Deed {
  struct Ramp {
    std::int64_t steps;
    bool back;
  };
  std::vector<Edited> values;
  std::optional<Ramp> ramp;              // they change evenly; otherwise at once
  std::shared_ptr<const Snapshot> from;  // where the run began that a restart left
};

/// The deeds so far, and those that were undone.
class EditLog {
 public:
  static constexpr std::size_t kLongest = 1000;  // deeds; older ones cannot be undone

  /// Adds a deed. One that `continues` becomes part of the last one, if that has set the same
  /// parameters; returns whether it did.
  bool add(Deed deed, bool continues);

  bool can_undo() const { return !done_.empty(); }
  bool can_redo() const { return !undone_.empty(); }
  const Deed& last() const { return done_.back(); }
  const Deed& next() const { return undone_.back(); }
  void undone();  // the last one
  void redone();  // the next one

 private:
  std::deque<Deed> done_;
  std::vector<Deed> undone_;
};

}  // namespace pupflow::window
