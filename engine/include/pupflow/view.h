// How to look at a litter from outside.
#pragma once

#include <cstdint>

namespace pupflow {

/// Two pups that touched in the last step, first < second.
struct TouchingPair {
  int first, second;
  friend bool operator==(const TouchingPair&, const TouchingPair&) = default;
};

}  // namespace pupflow
