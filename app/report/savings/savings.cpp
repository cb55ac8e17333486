#include "app/report/savings/savings.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstdio>
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

constexpr std::chrono::seconds kPatience{5};  // for measuring, whatever the size of the scene

/// One run of the scene and the time that its steps take.
class Run {
 public:
  Run(const Params& params, const Plan& forced, std::optional<ObservableSet> wanted = std::nullopt)
      : simulation_(params) {
    simulation_.set_observed(wanted.has_value());
    simulation_.force_plan(forced);
    if (wanted) observer_.emplace(simulation_, *wanted);
  }

  void step(StageListener* listener = nullptr) {
    if (io::interrupted()) throw io::Failure(io::ExitCode::interrupted, "interrupted");
    const Status status = simulation_.step(listener);
    if (!status.ok()) throw io::Failure(io::ExitCode::bad_numbers, status.message());
  }

  /// Two steps, the first timed stage by stage, the second as a whole: a step that nobody listens
  /// to takes a pup through several stages while its points are at hand.
  void two_timed_steps() {
    step(&timer);
    if (observer_) observer_->observe(simulation_);
    const Clock::time_point start = Clock::now();
    step();
    const Clock::time_point looking = Clock::now();
    if (observer_) {
      observer_->observe(simulation_);
      observing.push_back(microseconds_since(looking));
    }
    whole.push_back(microseconds_since(start));
  }

  const Simulation& simulation() const { return simulation_; }
  void set_threads(int threads) { simulation_.set_threads(threads); }

  StageTimer timer;
  std::vector<double> whole, observing;  // microseconds; a whole step and looking at it

 private:
  Simulation simulation_;
  std::optional<Observer> observer_;
};

/// A part that the plan leaves out, and what to force in against that.
struct Omission {
  std::string name, reason;
  Stage stage;  // that it is, or is a part of
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

/// The median of what `b` has more than `a`, pair by pair.
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
struct Field {
  explicit Field(const Params& params)
      : omissions(omissions_of(params)),
        planned(params, {}),
        glanced(params, {}, ObservableSet().add(Observable::mean_tb)),
        watched(params, {}, ObservableSet::all()),
        full(params, everything(), ObservableSet::all()) {
    for (const Omission& omission : omissions) forced.emplace_back(params, omission.more);
    if (planned.simulation().plan().has(pupflow::Part::quadratic)) {
      Params rigid = params;
      rigid.deformation = 0;
      twin.emplace(rigid, Plan{});
    }
  }

  std::vector<Run*> all() {
    std::vector<Run*> runs{&planned, &glanced, &watched, &full};
    for (Run& run : forced) runs.push_back(&run);
    if (twin) runs.push_back(&*twin);
    return runs;
  }

  std::vector<Omission> omissions;
  Run planned, glanced, watched,
      full;                 // nobody looks; at one observable; at all of them; and forced
  std::deque<Run> forced;   // one for each omission
  std::optional<Run> twin;  // with beta = 0, where the scene has quadratic terms: what they cost
};

void settle(const std::vector<Run*>& runs, const MeasuredSteps& steps) {
  const auto count = static_cast<std::int64_t>(runs.size());
  io::Progress progress("settle", steps.after * count, steps.quiet);
  for (std::int64_t step = 0; step < steps.after; ++step) {
    for (Run* run : runs) run->step();
    progress.update((step + 1) * count);
  }
}

/// A few steps of each in turn. Not step by step: one that has just seen the same step done by
/// another is faster than any real run, as the processor has learnt its branches.
void measure(std::vector<Run*> runs, int count) {
  constexpr int kBlock = 20;  // even
  const Clock::time_point begin = Clock::now();
  for (int done = 0; done < count && (done == 0 || Clock::now() - begin < kPatience);) {
    for (Run* run : runs) {
      for (int i = 0; i < kBlock; i += 2) run->two_timed_steps();
    }
    done += kBlock;
    std::rotate(runs.begin(), runs.begin() + 1, runs.end());  // each is first as often as another
  }
}

Part left_out(const Omission& omission, const Run& planned, const Run& forced) {
  const bool whole_stage = !planned.simulation().plan().has(omission.stage);
  Part part{omission.name, !whole_stage, false, omission.reason};
  part.planned = whole_stage ? planned.timer.median(omission.stage) : 0;
  part.forced = whole_stage ? forced.timer.median(omission.stage)
                            : median_difference(planned.timer.times(omission.stage),
                                                forced.timer.times(omission.stage));
  part.agreement = agreement(planned.simulation(), forced.simulation());
  return part;
}

std::vector<Part> parts_of(const Field& field) {
  std::vector<Part> parts;
  const Plan& plan = field.planned.simulation().plan();
  for (int i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    const StageTimer& timer = field.planned.timer;
    if (plan.has(stage))
      parts.push_back({std::string(stage_name(stage)), false, true, "", timer.median(stage)});
    for (std::size_t k = 0; k < field.omissions.size(); ++k) {
      if (field.omissions[k].stage != stage) continue;
      parts.push_back(left_out(field.omissions[k], field.planned, field.forced[k]));
    }
    if (stage == Stage::shape_match && field.twin) {
      const double cost = median_difference(field.twin->timer.times(stage), timer.times(stage));
      parts.push_back({std::string(part_name(pupflow::Part::quadratic)), true, true, "", cost});
    }
  }
  Part observables{
      "observables", false, false,
      "worked out only for steps that somebody asks about: a sweep asks for none until "
      "its means are near"};
  observables.planned = median(field.planned.observing);
  observables.forced = median(field.watched.observing);
  observables.agreement = agreement(field.planned.simulation(), field.watched.simulation());
  parts.push_back(observables);
  if (field.planned.simulation().pups() == 0) return parts;
  Part others{"all but mean T_b", true, false, "an observer works out what it is asked for"};
  others.forced = median_difference(field.glanced.observing, field.watched.observing);
  others.agreement = agreement(field.glanced.simulation(), field.watched.simulation());
  parts.push_back(others);
  return parts;
}

std::string figure(double microseconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%9.2f", microseconds);
  return text;
}

std::string nothing() {
  return std::string(8, ' ') + "0";
}

std::string none() {
  return std::string(8, ' ') + "-";
}

std::string hexadecimal(std::uint64_t hash) {
  char text[24];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace

std::string threads_words(int threads) {
  return threads == 1 ? "one thread" : std::to_string(threads) + " threads";
}

const char* agreement_words(Agreement agreement) {
  switch (agreement) {
    case Agreement::needed:
      return "-";
    case Agreement::whole_state:
      return "whole state";
    case Agreement::all_but_headings:
      return "all but headings";
    case Agreement::none:
      break;
  }
  return "NO";
}

Savings measure_savings(const Params& params, const MeasuredSteps& steps) {
  Field field(params);
  const std::vector<Run*> runs = field.all();
  for (Run* run : runs) run->set_threads(steps.threads);
  settle(runs, steps);
  measure(runs, steps.count);
  Savings savings;
  savings.first = steps.after + 1;
  savings.threads = steps.threads;
  savings.last = field.planned.simulation().steps_done();
  savings.parts = parts_of(field);
  savings.planned_step = median(field.planned.whole);
  savings.full_step = median(field.full.whole);
  savings.saved = median_difference(field.planned.whole, field.full.whole);
  savings.agreement = agreement(field.planned.simulation(), field.full.simulation());
  savings.clock = clock_cost();
  savings.hash = field.planned.simulation().hash();
  savings.rest_hash = hash_without_headings(field.planned.simulation());
  return savings;
}

void require_same_bits(const Savings& savings) {
  const auto require = [&](Agreement agreement, const std::string& what) {
    if (agreement != Agreement::none) return;
    throw io::Failure(io::ExitCode::bad_numbers, "a defect of pupflow: by step " +
                                                     std::to_string(savings.last) + " " + what +
                                                     " forced in has changed the result");
  };
  for (const Part& part : savings.parts) require(part.agreement, part.name);
  require(savings.agreement, "everything");
}

std::vector<io::Row> savings_rows(const Savings& savings) {
  std::vector<io::Row> rows{
      {"stage", "needed", "µs a step", "of the step", "forced in", "saved", "the same bits"}};
  double stages = 0;
  for (const Part& part : savings.parts) stages += part.of_stage ? 0 : part.planned;
  for (const Part& part : savings.parts) {
    const bool never_ran = !part.needed && part.planned == 0;
    rows.push_back({(part.of_stage ? "- " : "") + part.name, part.needed ? "yes" : "no",
                    never_ran ? nothing() : figure(part.planned), io::bar(part.planned, stages),
                    part.needed ? none() : figure(part.forced),
                    part.needed ? none() : figure(part.forced - part.planned),
                    agreement_words(part.agreement)});
  }
  rows.push_back({"whole step", "", figure(savings.planned_step), "", figure(savings.full_step),
                  figure(savings.saved), agreement_words(savings.agreement)});
  return rows;
}

std::vector<std::string> savings_notes(const Savings& savings) {
  std::vector<std::string> notes;
  char text[800];
  std::snprintf(
      text, sizeof text,
      "Medians over steps %lld to %lld, %s, of runs that take turns every few steps; "
      "reading the clock adds %.2f µs to each. Every other step is timed as a whole, which can "
      "take less than its stages do one by one; its forced figure is with all parts at once, and "
      "what it saved is the median difference, of which a percent or two of the step is noise. "
      "What a part of a stage saved is the median difference of the stage; less than some percent "
      "of that is noise.",
      static_cast<long long>(savings.first), static_cast<long long>(savings.last),
      threads_words(savings.threads).c_str(), savings.clock);
  notes.emplace_back(text);
  bool headings = false;
  std::string left_out;
  for (const Part& part : savings.parts) {
    headings = headings || part.agreement == Agreement::all_but_headings;
    if (part.needed) continue;
    left_out += (left_out.empty() ? "" : "; ") + part.name + " (" + part.reason + ")";
  }
  notes.push_back("Left out: " + left_out + ".");
  notes.push_back("After step " + std::to_string(savings.last) +
                  " the hash of the whole state is " + hexadecimal(savings.hash) +
                  ", with and without each part that says so.");
  if (headings) {
    notes.push_back(
        "Steering turns the headings of pups that have no drive, and nothing reads those: without "
        "them the hash is " +
        hexadecimal(savings.rest_hash) + " either way.");
  }
  return notes;
}

}  // namespace pupflow::report
