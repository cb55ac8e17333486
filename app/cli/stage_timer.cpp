#include "app/cli/stage_timer.h"

#include <algorithm>

namespace pupflow::cli {

void StageTimer::stage_begins(Stage) {
  begin_ = std::chrono::steady_clock::now();
}

void StageTimer::stage_ends(Stage stage) {
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin_;
  times_[static_cast<std::size_t>(stage)].push_back(time.count());
}

double StageTimer::median(Stage stage) const {
  return cli::median(times_[static_cast<std::size_t>(stage)]);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace pupflow::cli
