#include "pupflow/schedule.h"

#include <algorithm>
#include <cmath>

#include "pupflow/parameters.h"

namespace pupflow {
namespace {

/// The course of one parameter from the change that began last: a + (b - a) s.
struct Course {
  std::int64_t begin = 0, end = 0;
  double a = 0, b = 0;

  double at(std::int64_t steps) const {
    if (steps >= end) return b;
    const double share = static_cast<double>(steps - begin) / static_cast<double>(end - begin);
    // Weights, since b - a may overflow; rounding must not leave the range of both.
    return std::clamp((1 - share) * a + share * b, std::min(a, b), std::max(a, b));
  }
};

bool acts_at(const Change& change, std::int64_t steps) {
  return change.pup && change.step <= steps && (!change.until || steps < *change.until);
}

std::string at_step(std::int64_t step) {
  return "at step " + std::to_string(step) + ": ";
}

/// What is wrong with a single change.
void check_change(const Params& params, const Change& change, std::vector<Problem>& problems) {
  const auto wrong = [&](std::string_view what, const std::string& message) {
    problems.push_back({std::string(what), at_step(change.step) + message});
  };
  const auto in_range = [](std::int64_t step) {
    return step >= 0 && static_cast<double>(step) <= kExactInteger;
  };
  if (!in_range(change.step)) wrong("step", "step must be a whole number 0 … 2^53 - 1");
  if (change.until && (*change.until <= change.step || !in_range(*change.until))) {
    wrong("until", "until = " + std::to_string(*change.until) + " must be after it");
  }
  if (change.settings.empty() == !change.pup) {
    wrong("step", change.pup ? "parameters and a pup are two changes; write them apart"
                             : "nothing changes; name a parameter, or a pup with force, heat or "
                               "turn");
  }
  for (const Change::Setting& setting : change.settings) {
    const Parameter& parameter = parameters()[setting.parameter];
    Problem problem;
    if (parameter.effect != Parameter::Effect::next_step) {
      wrong(parameter.name, std::string(parameter.name) + " can only be set for the whole run");
    } else if (change.until && parameter.kind != Parameter::Kind::real) {
      wrong(parameter.name,
            std::string(parameter.name) + " changes at once and has no values between: no until");
    } else if (!check_value(parameter, setting.value, problem)) {
      wrong(parameter.name, problem.message);
    }
  }
  if (!change.pup) return;
  if (*change.pup < 0 || *change.pup >= params.pups) {
    wrong("pup", "there is no pup " + std::to_string(*change.pup) + " among " +
                     std::to_string(params.pups));
  }
  if (!change.action.acts()) wrong("pup", "nothing is done to the pup; name force, heat or turn");
  const Action& action = change.action;
  if (!std::all_of(action.force.begin(), action.force.end(),
                   [](double f) { return std::isfinite(f); }))
    wrong("force", "force must be three finite numbers");
  if (!std::isfinite(action.heat)) wrong("heat", "heat must be a finite number");
  if (!std::isfinite(action.turn.value_or(0))) wrong("turn", "turn must be a finite number");
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

void Schedule::apply(const Params& start, std::int64_t steps, Params& params) const {
  if (empty()) return;
  std::vector<std::optional<Course>> courses(parameters().size());
  for (const Change& change : changes_) {
    if (change.step > steps) break;
    for (const Change::Setting& setting : change.settings) {
      std::optional<Course>& course = courses[setting.parameter];
      const double before =
          course ? course->at(change.step) : parameters()[setting.parameter].get(start);
      course = {change.step, change.until.value_or(change.step), before, setting.value};
    }
  }
  for (std::size_t i = 0; i < courses.size(); ++i) {
    if (courses[i]) parameters()[i].set(params, courses[i]->at(steps));
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

std::vector<Problem> check_schedule(const Params& params) {
  std::vector<Problem> problems;
  for (const Change& change : params.schedule.changes()) check_change(params, change, problems);
  if (!problems.empty()) return problems;
  // Between the ends of changes all values lie between those at the ends.
  Params at = params;
  at.schedule = {};
  for (const Change& change : params.schedule.changes()) {
    for (const std::int64_t step : {change.step, change.until.value_or(change.step)}) {
      params.schedule.apply(params, step, at);
      for (const Problem& problem : check(at)) {
        problems.push_back({problem.parameter, at_step(step) + problem.message});
      }
      if (!problems.empty()) return problems;
    }
  }
  return problems;
}

}  // namespace pupflow
