// The recent past of the observables, for rolling plots.
#pragma once

#include <array>
#include <cstddef>

#include "pupflow/fields.h"

namespace pupflow::window {

/// A ring of samples, each the mean over kStepsPerSample steps (flow jumps from step to step).
class History {
 public:
  static constexpr int kSamples = 600;
  static constexpr int kStepsPerSample = 5;

  /// Adds what was seen after one step at model time `time`.
  void add(double time, const Observables& seen);
  void clear() { *this = History{}; }

  int size() const { return size_; }

  /// Sample `i` of an observable, oldest first, 0 <= i < size().
  float value(std::size_t observable, int i) const {
    return values_[observable][static_cast<std::size_t>(slot(i))];
  }
  /// Model time at the end of sample `i`.
  double time(int i) const { return times_[static_cast<std::size_t>(slot(i))]; }

 private:
  int slot(int i) const { return (first_ + i) % kSamples; }

  std::array<std::array<float, kSamples>, kObservableCount> values_{};
  std::array<double, kSamples> times_{};
  std::array<double, kObservableCount> sums_{};
  int summed_ = 0;
  int first_ = 0, size_ = 0;
};

}  // namespace pupflow::window
