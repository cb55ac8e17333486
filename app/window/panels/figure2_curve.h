// The huddling curve of the program's own Figure 2.
#pragma once

#include <span>

namespace pupflow::window {

/// Of one ambient temperature: the mean of 1 - A over seeds, and its standard deviation.
struct HuddlingPoint {
  double ta, huddling, deviation;
};

/// By rising T_a, for the paper's litter (docs/data/figure2-course-60-seeds.csv, which docs/validation.md
/// says how to make).
std::span<const HuddlingPoint> figure2_curve();

}  // namespace pupflow::window
