#include "pupflow/schedule.h"

#include <algorithm>

namespace pupflow {
namespace {

bool acts_at(const Change& change, std::int64_t steps) {
  return change.pup && change.step <= steps && (!change.until || steps < *change.until);
}

}  // namespace

Action& Action::operator+=(const Action& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) force[axis] += other.force[axis];
  heat += other.heat;
  if (other.turn) turn = other.turn;
  return *this;
}

void Schedule::add(Change change) {
  const auto place =
      std::upper_bound(changes_.begin(), changes_.end(), change.step,
                       [](std::int64_t step, const Change& later) { return step < later.step; });
  changes_.insert(place, std::move(change));
}

void Schedule::set(std::int64_t step, std::size_t parameter, double value) {
  const Change change{
      .step = step, .until = {}, .settings = {{parameter, value}}, .pup = {}, .action = {}};
  const auto repeated = std::find_if(changes_.rbegin(), changes_.rend(),
                                     [&](const Change& old) { return old.step <= step; });
  const bool replaces = repeated != changes_.rend() && repeated->step == step && !repeated->until &&
                        repeated->settings.size() == 1 &&
                        repeated->settings[0].parameter == parameter;
  if (replaces) {
    *repeated = change;
  } else {
    add(change);
  }
}

std::vector<Action> Schedule::actions(std::int64_t steps, int pups) const {
  std::vector<Action> actions;
  for (const Change& change : changes_) {
    if (!acts_at(change, steps)) continue;
    actions.resize(static_cast<std::size_t>(pups));
    actions[static_cast<std::size_t>(*change.pup)] += change.action;
  }
  return actions;
}

std::int64_t Schedule::next_change(std::int64_t steps) const {
  std::int64_t next = kNever;
  for (const Change& change : changes_) {
    if (change.step > steps) return std::min(next, change.step);
    if (!change.until || *change.until <= steps) continue;
    next = std::min(next, change.pup ? *change.until : steps + 1);
  }
  return next;
}

}  // namespace pupflow
