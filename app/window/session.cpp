#include "app/window/session.h"

#include <new>
#include <type_traits>

namespace pupflow::window {

Session::Session(const Params& params, bool playing, int threads)
    : simulation_(params), threads_(threads), playing_(playing) {
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
          edit(asked.params);
        } else if constexpr (std::is_same_v<Asked, Restart>) {
          restart(simulation_.params());
        } else if constexpr (std::is_same_v<Asked, Observe>) {
          observe(asked.on);
        } else if constexpr (std::is_same_v<Asked, ColorBy>) {
          color_by_ = asked.field;
          record();
        } else {
          static_assert(std::is_same_v<Asked, Suspend>);
          suspended_ = asked.on;
        }
      },
      command);
}

void Session::edit(const Params& params) {
  rejected_.clear();
  const std::vector<Problem> problems = check(params);
  if (!problems.empty()) {
    rejected_ = problems.front().message;
  } else if (needs_restart(simulation_.params(), params)) {
    restart(params);
  } else if (params != simulation_.params()) {
    simulation_.set_params(params);
    edited_at_ = simulation_.steps_done();
  }
}

void Session::restart(const Params& params) {
  try {
    simulation_ = Simulation(params);
  } catch (const std::bad_alloc&) {
    rejected_ = "not enough memory for " + std::to_string(params.pups) + " pups of " +
                std::to_string(points_per_pup(params)) + " points; fewer of either would fit";
    return;
  }
  pending_ = 0;
  edited_at_ = 0;
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
  history_.add(simulation_.time(), *observables_);
}

void Session::fill(LiveState& state, bool with_hash) {
  changed_ = false;
  state.litter.take(simulation_, color_by_->velocities);
  state.observables = observables_;
  state.history = history_;
  state.edited_at = edited_at_;
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
