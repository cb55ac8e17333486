// How long the stages of a step take.
#pragma once

#include <array>
#include <chrono>
#include <vector>

#include "engine/simulation.h"

namespace pupflow::cli {

/// Collects the duration of every stage that it hears of. Times in microseconds.
class StageTimer : public StageListener {
 public:
  void stage_begins(Stage stage) override;
  void stage_ends(Stage stage) override;

  /// Median over the collected steps; 0 for a stage that never ran.
  double median(Stage stage) const;

 private:
  std::chrono::steady_clock::time_point begin_;
  std::array<std::vector<double>, kStageCount> times_;
};

/// The median of `values`; 0 when there are none.
double median(std::vector<double> values);

}  // namespace pupflow::cli
