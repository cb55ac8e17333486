// The numbers of the deformation modes (cloud.h). The kernels include this, so it includes nothing.
#pragma once

namespace pupflow {

/// The modes in their order: the mean, three linear ones, five quadratic ones.
constexpr int kMeanMode = 0, kLinearModes = 3, kQuadraticModes = 5;
constexpr int kModes = 1 + kLinearModes + kQuadraticModes;

/// How many modes there are, with or without the quadratic ones.
constexpr int mode_count(bool quadratic) {
  return 1 + kLinearModes + (quadratic ? kQuadraticModes : 0);
}

}  // namespace pupflow
