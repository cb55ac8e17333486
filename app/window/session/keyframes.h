// States of a run from which its other states are stepped again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "pupflow/simulation.h"

namespace pupflow::window {

/// Snapshots at multiples of some number of steps. Runs that share steps share their keyframes. The
/// schedule is left out of them: it belongs to the run.
class Keyframes {
 public:
  /// Steps from one to the next while there is room.
  static constexpr std::int64_t kSpacing = 100;

  /// Whether a litter that has done `steps` steps should be added.
  bool wants(std::int64_t steps) const {
    return steps % spacing_ == 0 && (frames_.empty() || frames_.back()->step < steps);
  }

  /// Adds a litter that has done more steps than all others.
  void add(const Simulation& simulation);

  /// The last one that has done at most `steps` steps, or nullptr.
  std::shared_ptr<const Snapshot> at_or_before(std::int64_t steps) const;

  /// Forgets those after `steps` steps.
  void cut(std::int64_t steps);

  /// Forgets every other one until the rest takes at most `bytes`.
  void keep_within(std::size_t bytes);

  /// About the memory that adding it takes.
  static std::size_t needed_for(const LitterView& litter) {
    constexpr std::size_t kBytesPerPoint = 6 * sizeof(double) + sizeof(int);
    return kBytesPerPoint * static_cast<std::size_t>(litter.pups) *
           static_cast<std::size_t>(litter.points);
  }

  std::size_t size() const { return frames_.size(); }
  std::size_t bytes() const;

 private:
  std::vector<std::shared_ptr<const Snapshot>> frames_;  // by step
  std::int64_t spacing_ = kSpacing;
};

}  // namespace pupflow::window
