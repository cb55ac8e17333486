// The recent past of the observables, for rolling plots.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "pupflow/observer.h"

namespace pupflow::window {

/// One observable as it is shown.
struct ObservableRow {
  const char* name;   // as in the files that the program writes
  const char* label;  // short, for people
  const char* unit;
  const char* doc;
  double Observables::*value;
  int digits;                 // after the point
  double span_min, span_max;  // a plot shows at least this much
};
constexpr std::size_t kObservableCount = 6;

/// Every member of Observables, in the order in which they are shown.
std::span<const ObservableRow, kObservableCount> observable_rows();

/// A ring of samples, each the mean over kStepsPerSample steps (flow jumps from step to step).
class History {
 public:
  static constexpr int kSamples = 600;
  static constexpr int kStepsPerSample = 5;

  /// Adds the observables after one step at model time `time`.
  void add(double time, const Observables& observables);
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
