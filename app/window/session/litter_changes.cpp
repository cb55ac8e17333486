// What changes the run of a litter.
#include <algorithm>
#include <new>
#include <utility>

#include "app/window/session/litter.h"

namespace pupflow::window {
namespace {

Schedule schedule_of(std::span<const Change> changes) {
  Schedule schedule;
  for (const Change& change : changes) schedule.add(change);
  return schedule;
}

bool sets(const Change& change, std::size_t parameter) {
  return std::any_of(change.settings.begin(), change.settings.end(),
                     [&](const Setting& setting) { return setting.parameter == parameter; });
}

/// The value with which the next step begins.
double next_value(const Params& recipe, std::int64_t steps, std::size_t parameter) {
  Params next = recipe;
  apply_schedule(recipe, steps, next);
  return parameters()[parameter].get(next);
}

std::string first_of(const std::vector<Problem>& problems) {
  return problems.empty() ? std::string{} : problems.front().message;
}

std::string not_enough_memory(const Params& params) {
  return "not enough memory for " + std::to_string(params.pups) + " pups of " +
         std::to_string(points_per_pup(params)) + " points; fewer of either would fit";
}

/// What stays of `schedule` when others set these parameters, and there are only so many pups.
Schedule without(const Schedule& schedule, std::span<const Setting> settings, int pups) {
  Schedule rest;
  for (Change change : schedule.changes()) {
    std::erase_if(change.settings, [&](const Setting& old) {
      return std::any_of(settings.begin(), settings.end(), [&](const Setting& setting) {
        return setting.parameter == old.parameter;
      });
    });
    if (change.pup ? *change.pup < pups : !change.settings.empty()) rest.add(std::move(change));
  }
  return rest;
}

}  // namespace

/// Whether the user made that change.
bool Litter::is_own(const Change& change) const {
  const auto begun = begun_with_.changes();
  return std::find(begun.begin(), begun.end(), change) == begun.end();
}

/// What stays of the changes that begin now or later, when those of the user's that `replaced` is
/// true of do not. In the past, of the user's own only what goes on with earlier ones stays.
template <class Replaced>
std::vector<Change> Litter::to_come(const Replaced& replaced) const {
  const auto changes = simulation_.recipe().schedule.changes();
  const auto goes_on = [&](const Change& change) {  // the way back of a ramp
    return std::any_of(changes.begin(), changes.end(), [&](const Change& earlier) {
      return earlier.step < at() && earlier.until == change.step && is_own(earlier) &&
             !change.settings.empty() && sets(earlier, change.settings[0].parameter);
    });
  };
  std::vector<Change> stay;
  const auto later =
      std::lower_bound(changes.begin(), changes.end(), at(),
                       [](const Change& change, std::int64_t step) { return change.step < step; });
  for (const Change& change : std::span(later, changes.end())) {
    const bool stays = !is_own(change) || (!replaced(change) &&
                                           (change.step == at() || !in_past() || goes_on(change)));
    if (stays) stay.push_back(change);
  }
  return stay;
}

/// What would be wrong with the recipe if `changes` were what begins now or later.
std::string Litter::problem_with(std::span<const Change> changes) const {
  Params trial = simulation_.recipe();
  trial.schedule = {};
  for (const Change& change : simulation_.recipe().schedule.changes()) {
    if (change.step < at()) trial.schedule.add(change);
  }
  for (const Change& change : changes) trial.schedule.add(change);
  return first_of(check(trial));
}

/// Makes `changes` what begins now or later. In the past another future begins.
void Litter::amend(std::span<const Change> changes) {
  if (in_past()) {
    other_ = run_;
    parted_at_ = at();
    run_.cut(at());
    thin_out();
  } else if (changes.empty() && nothing_to_come()) {
    return;
  }
  simulation_.set_schedule(schedule_of(changes));
  run_.recipe = simulation_.recipe();
}

/// Whether nothing goes on or begins now or later.
bool Litter::nothing_to_come() const {
  return simulation_.recipe().schedule.next_change(at() - 1) == Schedule::kNever;
}

std::string Litter::set(std::span<const Setting> settings) {
  const auto replaced = [&](const Change& change) {
    return std::any_of(settings.begin(), settings.end(),
                       [&](const Setting& setting) { return sets(change, setting.parameter); });
  };
  Params wanted = params();
  for (const auto& [place, value] : settings) parameters()[place].set(wanted, value);
  if (std::string problem = first_of(check(wanted)); !problem.empty()) return problem;
  const std::vector<Change> stay = to_come(replaced);
  std::vector<Change> trial = stay;
  for (const Setting& setting : settings) {
    if (parameters()[setting.parameter].effect != Parameter::Effect::next_step) continue;
    trial.push_back({.step = at(), .until = {}, .settings = {setting}, .pup = {}, .action = {}});
  }
  if (!nothing_to_come()) {  // otherwise `wanted` tells all; a long recipe takes long to check
    if (std::string problem = problem_with(trial); !problem.empty()) return problem;
  }
  forget_what_was_set_now(replaced, settings, stay);
  const std::int64_t lag = params().flow_lag;
  simulation_.set_params(wanted);
  set_in_spite_of_ramps(settings);
  run_.recipe = simulation_.recipe();
  for (const Setting& setting : settings) run_.end_ramps(setting.parameter, at());
  if (params().flow_lag != lag) prepare();
  return {};
}

/// Amends, and shows the values that hold without what the user had set at this step before.
template <class Replaced>
void Litter::forget_what_was_set_now(const Replaced& replaced, std::span<const Setting> settings,
                                     std::span<const Change> stay) {
  const auto old = simulation_.recipe().schedule.changes();
  const bool forgets = std::any_of(old.begin(), old.end(), [&](const Change& change) {
    return change.step == at() && is_own(change) && replaced(change);
  });
  amend(stay);
  if (!forgets) return;
  Params now = params();
  for (const Setting& setting : settings) {
    parameters()[setting.parameter].set(now,
                                        next_value(simulation_.recipe(), at(), setting.parameter));
  }
  show(now);
}

/// A ramp that goes on may just pass the value that is set.
void Litter::set_in_spite_of_ramps(std::span<const Setting> settings) {
  Schedule schedule = simulation_.recipe().schedule;
  bool changed = false;
  for (const auto& [place, value] : settings) {
    if (next_value(simulation_.recipe(), at(), place) == value) continue;
    schedule.set(at(), place, value);
    changed = true;
  }
  if (changed) simulation_.set_schedule(schedule);
}

std::string Litter::ramp(std::size_t parameter, std::span<const Change> changes) {
  std::vector<Change> all = to_come([&](const Change& change) {
    return sets(change, parameter) && (change.step > at() || change.until);
  });
  all.insert(all.end(), changes.begin(), changes.end());
  if (std::string problem = problem_with(all); !problem.empty()) return problem;
  amend(all);
  run_.end_ramps(parameter, at());
  return {};
}

void Litter::act(const Change& change) {
  std::vector<Change> all = to_come([](const Change&) { return false; });
  all.push_back(change);
  amend(all);
}

Params Litter::start() const {
  Params start = params();
  for (const Change& change : begun_with_.changes()) {
    for (const auto& [place, value] : change.settings) {
      const Parameter& parameter = parameters()[place];
      parameter.set(start, parameter.get(run_.recipe));
    }
  }
  start.schedule = begun_with_;
  return start;
}

std::string Litter::restart(const Params& recipe, std::shared_ptr<const Snapshot> from) {
  if (std::string problem = first_of(check(recipe)); !problem.empty()) return problem;
  Run begun{.recipe = recipe, .from = std::move(from)};
  try {
    simulation_ = begun.kept_at(begun.first());
  } catch (const std::bad_alloc&) {
    return not_enough_memory(recipe);
  }
  begun.last = begun.first();
  target_.reset();
  other_ = std::exchange(run_, std::move(begun));
  parted_at_ = run_.first();
  prepare();
  thin_out();
  return {};
}

void Litter::swap() {
  std::swap(run_, *other_);
  seek_anew(run_.last);
}

std::string Litter::beside(std::span<const Setting> different, bool from_now,
                           std::optional<Litter>& second) const {
  const bool new_one = !from_now && !run_.from;
  for (const Setting& setting : different) {
    const Parameter& parameter = parameters()[setting.parameter];
    if (new_one || parameter.effect != Parameter::Effect::restart) continue;
    return std::string(parameter.name) + " defines the litter, so both must begin anew" +
           (from_now ? "" : ", and this run began from a checkpoint");
  }
  try {
    Litter other = from_now ? forked() : from_begin(different);
    std::string problem = new_one ? std::string{} : other.set(different);
    if (problem.empty()) second = std::move(other);
    return problem;
  } catch (const InvalidParams& problem) {
    return first_of(problem.problems());
  } catch (const std::bad_alloc&) {
    return not_enough_memory(params());
  }
}

/// As it is now, with the run so far.
Litter Litter::forked() const {
  Litter fork = *this;
  fork.amend(fork.to_come([](const Change&) { return false; }));
  fork.other_.reset();
  return fork;
}

/// From the beginning of the run. Values at the start are those that are `different`; where it began
/// from a checkpoint, they are still to be set.
Litter Litter::from_begin(std::span<const Setting> different) const {
  Params recipe = run_.recipe;
  if (!run_.from) {
    for (const auto& [place, value] : different) parameters()[place].set(recipe, value);
  }
  recipe.schedule = without(run_.recipe.schedule, different, recipe.pups);
  Litter begun(recipe, run_.from, threads_, watched_);
  begun.begun_with_ = without(begun_with_, different, recipe.pups);
  return begun;
}

}  // namespace pupflow::window
