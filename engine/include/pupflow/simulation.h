/// @file
/// The face of the library: parameters in, step, look.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "pupflow/instruction_set.h"
#include "pupflow/parameters.h"
#include "pupflow/plan.h"
#include "pupflow/snapshot.h"
#include "pupflow/status.h"

#pragma GCC visibility push(default)
namespace pupflow {

class LitterModel;

/// One litter in its arena. A value: copying it copies the whole state (that is how to take and
/// restore a snapshot), and a copy goes on bit for bit like the original. Not thread-safe; separate
/// objects may be used from separate threads.
class Simulation {
 public:
  /// The litter of `params` at t = 0. Throws InvalidParams when `check(params)` finds a problem.
  /// Results do not depend on `set`, which must be one of supported_instruction_sets().
  explicit Simulation(const Params& params,
                      InstructionSet set = supported_instruction_sets().back());

  /// The litter of a snapshot, which goes on like the one it was taken from. Throws InvalidParams,
  /// and std::invalid_argument when the numbers do not fit the parameters.
  explicit Simulation(const Snapshot& snapshot,
                      InstructionSet set = supported_instruction_sets().back());

  /// A copy has the whole state. One that was moved from may only be destroyed or assigned to.
  ///@{
  Simulation(const Simulation& other);
  Simulation(Simulation&& other) noexcept;
  Simulation& operator=(const Simulation& other);
  Simulation& operator=(Simulation&& other) noexcept;
  ///@}

  ~Simulation();

  /// The parameters of the last step, or those set since.
  const Params& params() const;

  /// The parameters of the start with the schedule, to which set_params adds: a simulation made from
  /// them repeats this one bit for bit, unless it was edited().
  const Params& recipe() const;

  /// Parameters for the steps to come; the schedule may change them later. Each one that is new
  /// becomes a change of the recipe at this step. `params.schedule` is not looked at. Throws
  /// InvalidParams when they are unsound, and std::logic_error when
  /// `needs_restart(this->params(), params)`: those define the litter.
  void set_params(const Params& params);

  /// What changes from here on, in place of what was to: of `schedule` the changes that begin at
  /// this step or later. Throws InvalidParams when the result is unsound.
  void set_schedule(const Schedule& schedule);

  /// What is done to a pup in the steps to come, beside what the schedule does, until it is set
  /// again. Not part of the recipe. Throws std::out_of_range for a pup that is not there,
  /// std::invalid_argument for a number that is not finite.
  void set_action(int pup, const Action& action);

  /// What was set so. Throws std::out_of_range for a pup that is not there.
  Action action(int pup) const;

  /// The steps done when pups were first set by hand (set_cloud, set_body_temperature, set_heading,
  /// set_action), here or in the snapshot that this was made from; none where the recipe tells all.
  std::optional<std::int64_t> edited() const;

  /// What is looked at after the steps to come: parts of the step whose results only an observer
  /// reads (fields.h says what each field needs). kContactRecords at first. A step records of the
  /// contacts what heat and steering read, and what is observed; the rest stays as it was. May
  /// change between any two steps: it changes no bit of the litter. Pup flow compares with the step
  /// flow_lag before, membership flow with the step before: these must be observed, too. Before the
  /// first step the sides and the strain of the litter at rest are recorded at once; poses are at
  /// any time.
  void set_observed(PartSet parts);

  /// Runs the stages and parts of `more` too, from the next step on, though the scene needs none of
  /// them; an empty plan ends that. For measuring what leaving out saves: positions, velocities and
  /// temperatures keep their bits. So do headings, but for drive = 0, where a forced steering turns
  /// pups that nothing drives.
  void force_plan(const Plan& more);

  /// How many threads share a step: 1 at first. Results keep their bits. A litter of few pups uses
  /// fewer, since waking a thread would cost more than it saves. Throws std::invalid_argument below
  /// 1. A copy has threads of its own.
  void set_threads(int threads);

  /// What a step does: the stages that the scene needs, and those that were forced.
  const Plan& plan() const;

  /// One step, t -> t + dt, of the model of Wilson 2017 (Methods); docs/model.md has its equations.
  /// After a bad status, which it then keeps returning, it does nothing. `listener` is told of each
  /// stage.
  Status step(StageListener* listener = nullptr);

  /// Up to `count` steps, ending at the first bad status.
  Status run(std::int64_t count);

  /// The status of the last step.
  const Status& status() const;

  /// The impossible states of all steps so far, the first of each kind, by step. They
  /// change nothing. A copy keeps them; a simulation made from a snapshot begins without any.
  std::span<const Warning> warnings() const;

  std::int64_t steps_done() const;  ///< since the start of the run, not of this object
  double time() const;              ///< model seconds
  int pups() const;                 ///< number of pups
  int points() const;               ///< per pup

  /// The litter as it is now. Valid until the simulation is stepped, edited, moved or destroyed.
  LitterView view() const;

  /// The same, so that functions that look at a litter take a simulation.
  operator LitterView() const { return view(); }  // NOLINT(google-explicit-constructor)

  /// Replaces the cloud of one pup, e.g. to set up an experiment: 3 * points() numbers each. Throws
  /// std::out_of_range for a pup that is not there, std::invalid_argument for a wrong size. Numbers
  /// that are not finite (in the litter's precision) are reported by the next step, by point.
  void set_cloud(int pup, std::span<const double> positions, std::span<const double> velocities);

  /// Sets T_b of a pup, normalised. Throws std::out_of_range for a pup that is not there. A value
  /// that is not finite is reported by the next heat stage.
  void set_body_temperature(int pup, double value);

  /// Sets the direction of travel. Throws std::out_of_range for a pup that is not there,
  /// std::invalid_argument for a number that is not finite.
  void set_heading(int pup, double radians);

  /// The whole state as plain numbers.
  Snapshot snapshot() const;

  /// Rotations since the start that came from flat, mirrored or collapsed clouds. With
  /// beta = 1 no rotation is worked out, so none is counted.
  std::int64_t rotation_fallbacks() const;

  /// Pairs of pups that were searched point by point since the start; pairs out of reach are not.
  std::int64_t searched_pairs() const;

  /// A hash of everything that the future depends on: positions, velocities, temperatures,
  /// headings, step count. Equal for equal bits, whatever the thread count or machine.
  std::uint64_t hash() const;

 private:
  std::unique_ptr<LitterModel> model_;
};

}  // namespace pupflow
#pragma GCC visibility pop
