#include "app/window/session/history.h"

namespace pupflow::window {
void History::add(double time, const Observables& seen) {
  for (std::size_t k = 0; k < kObservableCount; ++k) sums_[k] += seen.*observables()[k].value;
  if (++summed_ < kStepsPerSample) return;
  if (size_ == kSamples) {
    first_ = slot(1);
  } else {
    ++size_;
  }
  const auto last = static_cast<std::size_t>(slot(size_ - 1));
  for (std::size_t k = 0; k < kObservableCount; ++k) {
    values_[k][last] = static_cast<float>(sums_[k] / kStepsPerSample);
  }
  times_[last] = time;
  sums_ = {};
  summed_ = 0;
}

}  // namespace pupflow::window
