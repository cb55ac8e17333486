#include "app/window/session/run.h"

#include <algorithm>
#include <utility>

namespace pupflow::window {

Simulation Run::kept_at(std::int64_t step) const {
  std::shared_ptr<const Snapshot> frame = keyframes.at_or_before(step);
  if (!frame) frame = from;
  if (!frame) return Simulation(recipe);
  Snapshot start = *frame;
  start.params = recipe;
  return Simulation(start);
}

void Run::cut(std::int64_t step) {
  last = step;
  keyframes.cut(step);
  history.truncate(step);
  std::erase_if(marks, [&](const Mark& mark) {
    return mark.step > step || mark.kind == Timeline::Kind::bad;
  });
  std::erase_if(warnings, [&](const Warning& warning) { return warning.step > step; });
  if (diverged_at > step) diverged_at.reset();
}

void Run::add(Mark mark) {
  const auto later =
      std::upper_bound(marks.begin(), marks.end(), mark.step,
                       [](std::int64_t step, const Mark& other) { return step < other.step; });
  marks.insert(later, std::move(mark));
}

void Run::end_ramps(std::size_t parameter, std::int64_t step) {
  for (Mark& mark : marks) {
    if (mark.ramped == parameter && mark.until > step) mark.until = step;
  }
}

}  // namespace pupflow::window
