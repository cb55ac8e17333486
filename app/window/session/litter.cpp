#include "app/window/session/litter.h"

#include <algorithm>
#include <utility>

namespace pupflow::window {
Litter::Litter(const Params& recipe, std::shared_ptr<const Snapshot> from, int threads,
               PartSet watched)
    : begun_with_(recipe.schedule),
      run_{.recipe = recipe, .from = std::move(from)},
      simulation_(run_.kept_at(run_.first())),
      threads_(threads),
      watched_(watched) {
  run_.recipe = simulation_.recipe();
  run_.last = run_.first();
  prepare();
}

void Litter::record(PartSet watched) {
  watched_ = watched;
  simulation_.set_observed(parts());
}

PartSet Litter::parts() const {
  return watched_ | ObservableSet::all().parts();
}

/// What a simulation needs that is new here.
void Litter::prepare() {
  simulation_.set_threads(threads_);
  simulation_.set_observed(parts());
  observables_.reset();
  observer_.reset();
  begin_to_observe();
}

/// Where contacts were not recorded, an observer that compares steps must see a step first.
void Litter::begin_to_observe() {
  const PartSet needed = ObservableSet::all().parts();
  const bool recorded = simulation_.view().recorded.includes(needed);
  if (at() > 0 && !recorded) return;
  observer_.emplace(simulation_);
  watched_from_ = at();
}

void Litter::step() {
  const bool known = in_past();
  if (!simulation_.step().ok()) {
    target_.reset();
    if (!known) mark_bad();
    return;
  }
  const bool arrived = target_ && at() >= *target_;
  look(target_ && !arrived && known);
  if (!known) keep();
  if (!arrived) return;
  target_.reset();
  refresh();
}

/// Nobody sees the observables of a step that is only `passing`.
void Litter::look(bool passing) {
  if (!observer_) {
    observer_.emplace(simulation_);
    watched_from_ = at();
  } else if (passing) {
    observer_->pass(simulation_);
    observables_.reset();
  } else {
    observables_ = observer_->observe(simulation_);
  }
}

/// Adds a step that is new to the run.
void Litter::keep() {
  run_.last = at();
  if (observables_) run_.history.add(at(), simulation_.time(), *observables_, simulation_);
  for (const Warning& warning : simulation_.warnings()) {
    const bool told = std::any_of(run_.warnings.begin(), run_.warnings.end(),
                                  [&](const Warning& old) { return old.kind == warning.kind; });
    if (!told) run_.warnings.push_back(warning);
  }
  if (!run_.keyframes.wants(at()) || Keyframes::needed_for(simulation_) > share()) return;
  run_.keyframes.add(simulation_);
  thin_out();
}

void Litter::mark_bad() {
  const Status& status = simulation_.status();
  const auto bad = [](const Run::Mark& mark) { return mark.kind == Timeline::Kind::bad; };
  if (std::any_of(run_.marks.begin(), run_.marks.end(), bad)) return;
  run_.add({{at(), {}, Timeline::Kind::bad, status.message()}});
}

void Litter::seek(std::int64_t step) {
  step = std::max(step, run_.first());
  target_.reset();
  if (ok() && step == at()) return;
  const std::int64_t before = step_before(step);
  const auto frame = run_.keyframes.at_or_before(before);
  const bool watched = observer_ && watched_from_ <= before;
  const bool nearer = at() < step && at() >= (frame ? frame->step : run_.first());
  if (ok() && watched && nearer) {
    target_ = step;
  } else {
    seek_anew(step);
  }
}

void Litter::seek_anew(std::int64_t step) {
  target_.reset();
  simulation_ = run_.kept_at(step_before(step));
  prepare();
  if (at() < step) {
    target_ = step;
  } else {
    refresh();
  }
}

/// The state from which steps must be taken so that the last one records what is wanted, and the
/// observables can be compared with those before.
std::int64_t Litter::step_before(std::int64_t step) const {
  return std::max<std::int64_t>(step - params().flow_lag, run_.first());
}

/// Shows what the user has set at this step, which the next one takes.
void Litter::refresh() {
  Params now = params();
  for (const Change& change : simulation_.recipe().schedule.changes()) {
    if (change.step != at() || change.until || !is_own(change)) continue;
    for (const auto& [place, value] : change.settings) parameters()[place].set(now, value);
  }
  show(now);
}

/// Takes what the schedule will bring anyway.
void Litter::show(const Params& now) {
  if (now == params()) return;
  const Schedule schedule = simulation_.recipe().schedule;
  simulation_.set_params(now);
  simulation_.set_schedule(schedule);
}

void Litter::forget_parting() {
  run_.diverged_at.reset();
  if (other_) other_->diverged_at.reset();
}

void Litter::keep_within(std::size_t bytes) {
  bytes_ = bytes;
  thin_out();
}

void Litter::thin_out() {
  run_.keyframes.keep_within(share());
  if (other_) other_->keyframes.keep_within(share());
}

}  // namespace pupflow::window
