// The rows of the mode table (cloud.h), for everybody who counts them.
#pragma once

namespace pupflow {

/// The mean, three linear modes, five quadratic ones, in this order.
constexpr int kMeanMode = 0, kLinearModes = 3, kQuadraticModes = 5;
constexpr int kModes = 1 + kLinearModes + kQuadraticModes;

}  // namespace pupflow
