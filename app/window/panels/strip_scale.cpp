#include "app/window/panels/strip_scale.h"

#include <algorithm>
#include <cmath>

namespace pupflow::window {
namespace {

constexpr double kLeastSteps = 100;

/// The least 1, 2 or 5 times a power of ten that is not below `value` > 0.
double round_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (value <= factor * power) return factor * power;
  }
  return 10 * power;
}

}  // namespace

float StripScale::x(double step) const {
  const double share = (step - static_cast<double>(first)) / static_cast<double>(end - first);
  return left + width * static_cast<float>(share);
}

std::int64_t StripScale::step(float x) const {
  const double share = std::clamp(static_cast<double>((x - left) / width), 0.0, 1.0);
  return first + std::llround(share * static_cast<double>(end - first));
}

StripScale strip_scale(const Timeline& timeline, float left, float width) {
  const std::int64_t other = timeline.parted_at ? timeline.other_last : timeline.first;
  const auto steps = static_cast<double>(std::max(timeline.last, other) - timeline.first);
  const double range = round_up(std::max(steps, kLeastSteps));
  return {timeline.first, timeline.first + std::llround(range), left, std::max(width, 1.0f)};
}

}  // namespace pupflow::window
