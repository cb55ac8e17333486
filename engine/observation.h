// What the formulas of the observables read.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "pupflow/view.h"

namespace pupflow {

/// A litter after a step, and what an observer remembers of the steps before. What no wanted
/// observable reads is empty.
struct Observation {
  const LitterView& litter;
  std::size_t lag = 1;                     // steps between `exposed_before` and now
  std::span<const double> exposed_before;  // of all pups; empty before `lag` steps have been seen
  std::span<const int> labels_before;      // groups after the step before
  std::span<const int> labels;             // groups now (group_labels)
  std::span<const int> group_sizes;        // by label
};

}  // namespace pupflow
