#include "app/report/savings/savings.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <deque>
#include <optional>

#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/progress.h"
#include "app/report/savings/stage_timer.h"
#include "engine/rng.h"
#include "pupflow/observer.h"
#include "pupflow/plan.h"

namespace pupflow::report {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kMeasuringTime{
    5};  // the longest time for measuring, for scenes of any size

/// One run of the scene and the times of its steps.
class Run {
 public:
  Run(const Params& params, const Plan& forced, std::optional<ObservableSet> wanted = std::nullopt)
      : simulation_(params) {
    simulation_.set_observed(wanted ? kContactRecords : PartSet{});
    simulation_.force_plan(forced);
    if (wanted) observer_.emplace(simulation_, *wanted);
  }

  void step(StageListener* listener = nullptr) {
    if (io::interrupted()) throw io::Failure(io::ExitCode::interrupted, "interrupted");
    const Status status = simulation_.step(listener);
    if (!status.ok()) throw io::Failure(io::ExitCode::bad_numbers, status.message());
  }

  /// Two steps, the first timed by stage, the second as a whole. A step without a listener takes one
  /// pup through several stages while its points are in the cache.
  void two_timed_steps() {
    step(&timer);
    if (observer_) observer_->observe(simulation_);
    const Clock::time_point start = Clock::now();
    step();
    const Clock::time_point stepped = Clock::now();
    if (observer_) {
      observer_->observe(simulation_);
      observing.push_back(microseconds_since(stepped));
    }
    whole.push_back(microseconds_since(start));
  }

  const Simulation& simulation() const { return simulation_; }
  void set_threads(int threads) { simulation_.set_threads(threads); }

  StageTimer timer;
  std::vector<double> whole, observing;  // microseconds of a whole step and of the observer

 private:
  Simulation simulation_;
  std::optional<Observer> observer_;
};

/// A part that the plan leaves out, and the plan that forces it in.
struct Omission {
  std::string name, reason;
  Stage stage;  // the stage itself, or the one that it is a part of
  Plan more;
};

std::vector<Omission> omissions_of(const Params& params) {
  std::vector<Omission> omissions;
  for (const Decision& decision : explain_plan(params, {})) {
    if (decision.needed) continue;
    Plan more;
    if (decision.part) {
      more.add(*decision.part);
    } else {
      more = whole_stage(decision.stage, params, {});
    }
    const std::string_view name =
        decision.part ? part_name(*decision.part) : stage_name(decision.stage);
    omissions.push_back({std::string(name), decision.reason, decision.stage, more});
  }
  return omissions;
}

Plan everything() {
  Plan plan;
  plan.stages.fill(true);
  plan.parts = PartSet::all();
  return plan;
}

/// The median of b_i - a_i.
double median_difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    differences.push_back(b[i] - a[i]);
  }
  return median(differences);
}

/// A hash of positions, velocities and temperatures.
std::uint64_t hash_without_headings(const Simulation& simulation) {
  const Snapshot snapshot = simulation.snapshot();
  std::uint64_t hash = 0;
  for (const auto* numbers :
       {&snapshot.positions, &snapshot.velocities, &snapshot.body_temperature}) {
    for (const double number : *numbers) {
      hash = mix_bits(hash ^ std::bit_cast<std::uint64_t>(number));
    }
  }
  return hash;
}

Agreement agreement(const Simulation& planned, const Simulation& forced) {
  if (planned.hash() == forced.hash()) return Agreement::whole_state;
  const bool undriven = planned.params().drive == 0 && forced.plan().has(Stage::steering);
  const bool rest = hash_without_headings(planned) == hash_without_headings(forced);
  return undriven && rest ? Agreement::all_but_headings : Agreement::none;
}

/// All runs of one scene.
struct Runs {
  explicit Runs(const Params& params)
      : omissions(omissions_of(params)),
        planned(params, {}),
        one_observed(params, {}, ObservableSet().add(Observable::mean_tb)),
        all_observed(params, {}, ObservableSet::all()),
        full(params, everything(), ObservableSet::all()) {
    for (const Omission& omission : omissions) forced.emplace_back(params, omission.more);
    if (planned.simulation().plan().has(Part::quadratic)) {
      Params rigid = params;
      rigid.deformation = 0;
      twin.emplace(rigid, Plan{});
    }
  }

  std::vector<Run*> all() {
    std::vector<Run*> runs{&planned, &one_observed, &all_observed, &full};
    for (Run& run : forced) runs.push_back(&run);
    if (twin) runs.push_back(&*twin);
    return runs;
  }

  std::vector<Omission> omissions;
  Run planned;                     // not observed
  Run one_observed, all_observed;  // one observable; all observables
  Run full;                        // all observables, and everything forced in
  std::deque<Run> forced;          // one for each omission
  std::optional<Run> twin;  // with beta = 0, where the scene has quadratic terms, for their time
};

void settle(const std::vector<Run*>& runs, const MeasuredSteps& steps) {
  const auto count = static_cast<std::int64_t>(runs.size());
  io::Progress progress("settle", steps.after * count, steps.quiet);
  for (std::int64_t step = 0; step < steps.after; ++step) {
    for (Run* run : runs) run->step();
    progress.update((step + 1) * count);
  }
}

/// Blocks of steps of each run in turn. Single steps in turn would be faster than those of a real
/// run, since the branch predictor has just seen the same step of another run.
void measure(std::vector<Run*> runs, int count) {
  constexpr int kBlock = 20;  // even
  const Clock::time_point begin = Clock::now();
  for (int done = 0; done < count && (done == 0 || Clock::now() - begin < kMeasuringTime);) {
    for (Run* run : runs) {
      for (int i = 0; i < kBlock; i += 2) run->two_timed_steps();
    }
    done += kBlock;
    std::rotate(runs.begin(), runs.begin() + 1, runs.end());  // so that each is first equally often
  }
}

PartCost left_out(const Omission& omission, const Run& planned, const Run& forced) {
  const bool whole_stage = !planned.simulation().plan().has(omission.stage);
  PartCost part{omission.name, !whole_stage, false, omission.reason};
  part.planned = whole_stage ? planned.timer.median(omission.stage) : 0;
  part.forced = whole_stage ? forced.timer.median(omission.stage)
                            : median_difference(planned.timer.times(omission.stage),
                                                forced.timer.times(omission.stage));
  part.agreement = agreement(planned.simulation(), forced.simulation());
  return part;
}

std::vector<PartCost> parts_of(const Runs& runs) {
  std::vector<PartCost> parts;
  const Plan& plan = runs.planned.simulation().plan();
  for (int i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    const StageTimer& timer = runs.planned.timer;
    if (plan.has(stage))
      parts.push_back({std::string(stage_name(stage)), false, true, "", timer.median(stage)});
    for (std::size_t k = 0; k < runs.omissions.size(); ++k) {
      if (runs.omissions[k].stage != stage) continue;
      parts.push_back(left_out(runs.omissions[k], runs.planned, runs.forced[k]));
    }
    if (stage == Stage::shape_match && runs.twin) {
      const double cost = median_difference(runs.twin->timer.times(stage), timer.times(stage));
      parts.push_back({std::string(part_name(Part::quadratic)), true, true, "", cost});
    }
  }
  PartCost observables{
      "observables", false, false,
      "computed only after steps that are observed: a sweep observes none before the steps of its "
      "means"};
  observables.planned = median(runs.planned.observing);
  observables.forced = median(runs.all_observed.observing);
  observables.agreement = agreement(runs.planned.simulation(), runs.all_observed.simulation());
  parts.push_back(observables);
  if (runs.planned.simulation().pups() == 0) return parts;
  PartCost others{"all but mean T_b", true, false,
                  "an observer computes only the observables that it is asked for"};
  others.forced = median_difference(runs.one_observed.observing, runs.all_observed.observing);
  others.agreement = agreement(runs.one_observed.simulation(), runs.all_observed.simulation());
  parts.push_back(others);
  return parts;
}

}  // namespace

Savings measure_savings(const Params& params, const MeasuredSteps& steps) {
  Runs runs(params);
  const std::vector<Run*> all = runs.all();
  for (Run* run : all) run->set_threads(steps.threads);
  settle(all, steps);
  measure(all, steps.count);
  Savings savings;
  savings.first = steps.after + 1;
  savings.threads = steps.threads;
  savings.last = runs.planned.simulation().steps_done();
  savings.parts = parts_of(runs);
  savings.planned_step = median(runs.planned.whole);
  savings.full_step = median(runs.full.whole);
  savings.saved = median_difference(runs.planned.whole, runs.full.whole);
  savings.agreement = agreement(runs.planned.simulation(), runs.full.simulation());
  savings.clock = clock_cost();
  savings.hash = runs.planned.simulation().hash();
  savings.rest_hash = hash_without_headings(runs.planned.simulation());
  return savings;
}

void require_same_bits(const Savings& savings) {
  const auto require = [&](Agreement agreement, const std::string& what) {
    if (agreement != Agreement::none) return;
    throw io::Failure(io::ExitCode::bad_numbers,
                      "a defect of pupflow: " + what +
                          " forced in has changed the state after step " +
                          std::to_string(savings.last));
  };
  for (const PartCost& part : savings.parts) require(part.agreement, part.name);
  require(savings.agreement, "everything");
}

}  // namespace pupflow::report
