#include "app/window/session/pacer.h"

#include <algorithm>
#include <cmath>

namespace pupflow::window {

void Pacer::reschedule(double now, double interval) {
  next_ = std::clamp(next_, now, now + interval);
}

void Pacer::stepped(double now, double interval) {
  next_ = std::max(next_ + interval, now - kLongestDelay);
}

double step_interval(double dt, double speed) {
  return std::isinf(speed) ? 0.0 : dt / speed;
}

}  // namespace pupflow::window
