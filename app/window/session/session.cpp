#include "app/window/session/session.h"

#include <new>
#include <type_traits>
#include <utility>

namespace pupflow::window {

Session::Session(const Params& params, bool playing, int threads, std::optional<Snapshot> from)
    : from_(std::move(from)),
      begun_with_(params.schedule),
      simulation_(from_ ? Simulation(*from_) : Simulation(params)),
      threads_(threads),
      playing_(playing) {
  simulation_.set_threads(threads_);
  record();
}

void Session::apply(const Command& command) {
  changed_ = true;
  std::visit(
      [this](const auto& asked) {
        using Asked = std::remove_cvref_t<decltype(asked)>;
        if constexpr (std::is_same_v<Asked, PlayPause>) {
          playing_ = !playing_ && simulation_.status().ok();
          pending_ = 0;
        } else if constexpr (std::is_same_v<Asked, Advance>) {
          playing_ = false;
          if (simulation_.status().ok()) pending_ += asked.steps;
        } else if constexpr (std::is_same_v<Asked, Speed>) {
          speed_ = asked.factor;
        } else if constexpr (std::is_same_v<Asked, Edit>) {
          edit(asked);
        } else if constexpr (std::is_same_v<Asked, Restart>) {
          restart_as_begun();
        } else if constexpr (std::is_same_v<Asked, Observe>) {
          observe(asked.on);
        } else if constexpr (std::is_same_v<Asked, ColorBy>) {
          color_by_ = asked.field;
          record();
        } else if constexpr (std::is_same_v<Asked, Suspend>) {
          suspended_ = asked.on;
        }
      },
      command);
}

void Session::edit(const Edit& asked) {
  rejected_.clear();
  Params wanted = simulation_.params();
  for (const Parameter& parameter : parameters()) {
    const double value = parameter.get(asked.params);
    const bool changed = !asked.before || parameter.get(*asked.before) != value;
    if (changed) parameter.set(wanted, value);
  }
  const std::vector<Problem> problems = check(wanted);
  if (!problems.empty()) {
    rejected_ = problems.front().message;
  } else if (needs_restart(simulation_.params(), wanted)) {
    from_.reset();
    wanted.schedule = begun_with_;
    restart(wanted);
  } else if (wanted != simulation_.params()) {
    simulation_.set_params(wanted);
  }
}

/// The same start again, with the values that were set since, but for those that the schedule sets.
void Session::restart_as_begun() {
  if (from_) {
    begin(Simulation(*from_));
    return;
  }
  Params start = simulation_.params();
  for (const Change& change : begun_with_.changes()) {
    for (const auto& [place, value] : change.settings) {
      const Parameter& parameter = parameters()[place];
      parameter.set(start, parameter.get(simulation_.recipe()));
    }
  }
  start.schedule = begun_with_;
  restart(start);
}

void Session::restart(const Params& params) {
  if (const std::vector<Problem> problems = check(params); !problems.empty()) {
    rejected_ = problems.front().message;
    return;
  }
  try {
    begin(Simulation(params));
  } catch (const std::bad_alloc&) {
    rejected_ = "not enough memory for " + std::to_string(params.pups) + " pups of " +
                std::to_string(points_per_pup(params)) + " points; fewer of either would fit";
  }
}

void Session::begin(Simulation simulation) {
  simulation_ = std::move(simulation);
  pending_ = 0;
  simulation_.set_threads(threads_);
  record();
  look_anew();
}

void Session::observe(bool on) {
  if (on == observed_) return;
  observed_ = on;
  record();
  look_anew();
}

/// Has the steps to come record what is shown.
void Session::record() {
  simulation_.set_observed((observed_ ? ObservableSet::all().parts() : PartSet{}) |
                           color_by_->parts);
}

// Before, contacts may not have been recorded: an observer that compares steps must see one step
// first, unless the litter is still untouched.
void Session::look_anew() {
  history_.clear();
  observables_.reset();
  observer_.reset();
  if (observed_ && simulation_.steps_done() == 0) observer_.emplace(simulation_);
}

void Session::step() {
  changed_ = true;
  if (pending_ > 0) --pending_;
  if (!simulation_.step().ok()) {
    playing_ = false;
    pending_ = 0;
    return;
  }
  if (!observed_) return;
  if (!observer_) {
    observer_.emplace(simulation_);
    return;
  }
  observables_ = observer_->observe(simulation_);
  history_.add(simulation_.steps_done(), simulation_.time(), *observables_, simulation_.view());
}

void Session::fill(LiveState& state, bool with_hash) {
  changed_ = false;
  state.litter.take(simulation_, color_by_->velocities);
  state.observables = observables_;
  state.history = history_;
  state.status = simulation_.status();
  const auto warnings = simulation_.warnings();
  state.warnings.assign(warnings.begin(), warnings.end());
  state.playing = playing_;
  state.speed = speed_;
  state.rejected = rejected_;
  state.hash.reset();
  if (with_hash) state.hash = simulation_.hash();
}

}  // namespace pupflow::window
