// A litter that is stepped, whatever the precision of its points: what stands behind a Simulation.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/step.h"
#include "pupflow/instruction_set.h"
#include "pupflow/plan.h"
#include "pupflow/snapshot.h"
#include "pupflow/status.h"

namespace pupflow {

/// What the face needs of a litter, whatever its precision.
class LitterModel {
 public:
  virtual ~LitterModel() = default;
  virtual std::unique_ptr<LitterModel> clone() const = 0;
  virtual Status advance(StageListener* listener) = 0;
  virtual LitterView view() const = 0;
  virtual void observe_start() = 0;  // records what is observed, before the first step
  virtual void observe_poses() = 0;  // records them where they are observed
  virtual void set_cloud(int pup, std::span<const double> positions,
                         std::span<const double> velocities) = 0;
  virtual std::vector<double>& tb() = 0;
  virtual std::vector<double>& heading() = 0;
  virtual const Warnings& warnings() const = 0;
  virtual void judge_anew() = 0;  // parameters or pups were set: warnings judge from here on
  virtual std::vector<Action>& actions() = 0;  // of the next step; empty: none
  virtual std::int64_t step() const = 0;
  virtual Clock& clock() = 0;
  virtual std::uint64_t hash() const = 0;
  virtual void load(const Snapshot& snapshot) = 0;  // whose sizes fit
  virtual void set_threads(int threads) = 0;

  /// Makes the plan anew, after a change of what it is made from.
  void replan() {
    kinds = {};
    for (const Action& action : actions()) {
      kinds.force |= action.force != std::array<double, 3>{};
      kinds.heat |= action.heat != 0;
      kinds.turn |= action.turn.has_value();
    }
    plan = joined(make_plan(params, observed, kinds), forced);
  }

  /// Parameters for the next step.
  void take(const Params& next) {
    if (next.dt != params.dt) clock() = {step(), clock().at(step(), params.dt)};
    const bool other_motion =
        next.dt != params.dt || next.gravity != params.gravity || next.drive != params.drive;
    params = next;
    if (other_motion) judge_anew();
  }

  /// What the schedule and the caller want of the next step. To be called when `next_change` is
  /// reached, or after `imposed` has changed.
  void take_changes() {
    Params next = params;
    apply_schedule(recipe, step(), next);
    if (next != params) take(next);
    actions() = recipe.schedule.actions(step(), params.pups);
    if (!imposed.empty()) {
      actions().resize(imposed.size());
      for (std::size_t pup = 0; pup < imposed.size(); ++pup) actions()[pup] += imposed[pup];
    }
    next_change = recipe.schedule.next_change(step());
    imposed_anew = false;
    replan();
  }

  void edit() {
    if (!edited) edited = step();
  }

  Params params, recipe;
  ActionKinds kinds;             // of the actions in the next step
  std::int64_t next_change = 0;  // the number of steps done at which take_changes is due
  std::vector<Action> imposed;   // by set_action, one per pup; empty: none
  bool imposed_anew = false;     // since the last step
  std::optional<std::int64_t> edited;
  Plan plan, forced;
  PartSet observed = kContactRecords;
  Status status;
  StepCounters counters;

 protected:
  explicit LitterModel(const Params& p) : params(p), recipe(p) { params.schedule = {}; }
  LitterModel(const LitterModel&) = default;
};

/// The litter of `params`, which must be sound, at t = 0, stepped by the kernels of `set`.
std::unique_ptr<LitterModel> make_litter_model(const Params& params, InstructionSet set);

}  // namespace pupflow
