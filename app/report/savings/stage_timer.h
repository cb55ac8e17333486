// How long the stages of a step take.
#pragma once

#include <array>
#include <chrono>
#include <vector>

#include "pupflow/simulation.h"

namespace pupflow::report {

/// Microseconds from `start` until now.
double microseconds_since(std::chrono::steady_clock::time_point start);

/// Collects the duration of every stage that it hears of. Times in microseconds.
class StageTimer : public StageListener {
 public:
  void stage_begins(Stage stage) override;
  void stage_ends(Stage stage) override;

  /// One time for each step in which the stage ran.
  const std::vector<double>& times(Stage stage) const;

  /// Their median; 0 for a stage that never ran.
  double median(Stage stage) const;

 private:
  std::chrono::steady_clock::time_point begin_;
  std::array<std::vector<double>, kStageCount> times_;
};

/// The median of `values`; 0 when there are none.
double median(std::vector<double> values);

/// What reading the clock adds to each time of a stage: the median time of a stage that does
/// nothing, microseconds.
double clock_cost();

}  // namespace pupflow::report
