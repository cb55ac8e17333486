#include "app/report/savings/stage_timer.h"

#include <algorithm>

namespace pupflow::report {

double microseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start)
      .count();
}

void StageTimer::stage_begins(Stage) {
  begin_ = std::chrono::steady_clock::now();
}

void StageTimer::stage_ends(Stage stage) {
  times_[static_cast<std::size_t>(stage)].push_back(microseconds_since(begin_));
}

const std::vector<double>& StageTimer::times(Stage stage) const {
  return times_[static_cast<std::size_t>(stage)];
}

double StageTimer::median(Stage stage) const {
  return report::median(times(stage));
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double clock_cost() {
  constexpr int kReadings = 1001;
  StageTimer timer;
  for (int i = 0; i < kReadings; ++i) {
    timer.stage_begins(Stage::boundary);
    timer.stage_ends(Stage::boundary);
  }
  return timer.median(Stage::boundary);
}

}  // namespace pupflow::report
