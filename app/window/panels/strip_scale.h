// Steps of a run on a strip of pixels.
#pragma once

#include <cstdint>

#include "app/window/session/session.h"

namespace pupflow::window {

/// Steps from `first` to `end`, evenly from `left` over `width`.
struct StripScale {
  std::int64_t first = 0, end = 1;
  float left = 0, width = 1;

  float x(double step) const;

  /// The step nearest to `x`, within first ... end.
  std::int64_t step(float x) const;
};

/// A strip for a run and its other future. It ends at 1, 2 or 5 times a power of ten steps, so that
/// it stands still while the run grows.
StripScale strip_scale(const Timeline& timeline, float left, float width);

}  // namespace pupflow::window
