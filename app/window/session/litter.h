// One litter with the run that it makes, and the future that was left for another one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/window/session/run.h"
#include "pupflow/fields.h"
#include "pupflow/observer.h"
#include "pupflow/simulation.h"

namespace pupflow::window {

/// A parameter that is set: its place in parameters() and its value.
using Setting = Change::Setting;

/// Steps a litter and keeps its run, so that every step of it can be gone back to. A change that is
/// made at an earlier step begins another future; the one that was there is kept as the other one.
class Litter {
 public:
  /// What the steps record, and for whom.
  struct Recording {
    PartSet parts;         // beside what the observables need
    bool observed = true;  // the observables of every step are worked out
  };

  /// A new litter, or the one of `from`, whose recipe is then `recipe`. Throws InvalidParams.
  Litter(const Params& recipe, std::shared_ptr<const Snapshot> from, int threads,
         const Recording& recording);

  const Simulation& simulation() const { return simulation_; }
  const Params& params() const { return simulation_.params(); }
  const Run& run() const { return run_; }
  const std::optional<Run>& other() const { return other_; }
  std::int64_t parted_at() const { return parted_at_; }  // meaningless without `other`
  std::int64_t at() const { return simulation_.steps_done(); }
  bool ok() const { return simulation_.status().ok(); }
  const std::optional<Observables>& observables() const {
    return observables_;
  }  // of the last step

  /// One step: towards where it was sent to, or on.
  void step();

  /// Goes to that step of the run, or on to it, in so many calls of `step` that `seeking` is false.
  void seek(std::int64_t step);
  bool seeking() const { return target_.has_value(); }

  /// The same to the step where it is, so that the last step records what is wanted now.
  void seek_anew() { seek_anew(at()); }

  void record(const Recording& recording);
  /// Whether the last step has recorded all that.
  bool recorded() const { return simulation_.view().recorded.includes(parts()); }

  // What changes the run. Each returns what is wrong with it, and then changes nothing; or nothing.

  /// Sets parameters of Effect::next_step or Effect::run from now on. What was still to come of the
  /// user's own changes of them does not.
  std::string set(std::span<const Setting> settings);

  /// Adds changes of one parameter, in place of what was still to come of the user's own.
  std::string ramp(std::size_t parameter, std::span<const Change> changes);

  /// Adds what is done to a pup: one that is there, and numbers that are finite.
  void act(const Change& change);

  /// The parameters with which `restart` begins it again: those in force, but for those that its own
  /// schedule sets, which are as they were at the start.
  Params start() const;

  /// Begins a run anew; this one becomes the other future.
  std::string restart(const Params& recipe, std::shared_ptr<const Snapshot> from);

  /// Goes to the end of the other future; this one is then the other.
  void swap();

  /// Makes `second` a litter to compare with: this one as it is now, or from the beginning of its
  /// run with all that was done since, but for the parameters that are to be `different`. Returns
  /// what is wrong with that, if anything.
  std::string beside(std::span<const Setting> different, bool from_now,
                     std::optional<Litter>& second) const;
  void forget_parting();

  Run& run() { return run_; }

  /// At most so much memory for keyframes.
  void keep_within(std::size_t bytes);

 private:
  // Simulation and observer.
  PartSet parts() const;
  void prepare();
  void begin_to_observe();
  void look(bool passing);

  // The run.
  bool in_past() const { return at() < run_.last; }
  void keep();
  void mark_bad();
  void seek_anew(std::int64_t step);
  std::int64_t step_before(std::int64_t step) const;
  std::size_t share() const { return other_ ? bytes_ / 2 : bytes_; }  // of a run
  void thin_out();

  // Changes.
  bool is_own(const Change& change) const;
  void refresh();
  void show(const Params& now);
  template <class Replaced>
  std::vector<Change> to_come(const Replaced& replaced) const;
  std::string problem_with(std::span<const Change> changes) const;
  void amend(std::span<const Change> changes);
  bool nothing_to_come() const;
  template <class Replaced>
  void forget_what_was_set_now(const Replaced& replaced, std::span<const Setting> settings,
                               std::span<const Change> stay);
  void set_in_spite_of_ramps(std::span<const Setting> settings);
  Litter forked() const;
  Litter from_begin(std::span<const Setting> different) const;

  Schedule begun_with_;  // what was to change when it began
  Run run_;
  std::optional<Run> other_;
  std::int64_t parted_at_ = 0;
  Simulation simulation_;
  int threads_;
  Recording recording_;
  std::size_t bytes_ = SIZE_MAX;      // for keyframes
  std::optional<Observer> observer_;  // none before the first step that it can compare with
  std::int64_t watched_from_ = 0;     // the step of the state that it saw first
  std::optional<Observables> observables_;
  std::optional<std::int64_t> target_;  // where it was sent to
};

}  // namespace pupflow::window
