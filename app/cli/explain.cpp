// pupflow explain: which stages a scene needs, why, and the time of each on this machine.
#include <cstdio>
#include <memory>

#include "app/cli/summary.h"
#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/json.h"
#include "app/io/progress.h"
#include "app/io/table.h"
#include "app/report/savings/savings.h"
#include "app/report/savings/stage_timer.h"
#include "pupflow/observer.h"
#include "pupflow/plan.h"
#include "pupflow/simulation.h"

namespace pupflow::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMeasuredSteps = 200;
constexpr std::chrono::seconds kMeasuringTime{5};  // for measuring, whatever the size of the scene

struct ExplainOptions {
  Common common;
  std::int64_t after = 300;
  bool measure = false;
  bool json = false;
};

int threads(const ExplainOptions& options) {
  return options.common.threads > 0 ? options.common.threads : 1;
}

/// The measured times, in microseconds.
struct Costs {
  int threads = 1;
  std::int64_t first = 0, last = 0;  // the measured steps
  report::StageTimer stages;
  double step = 0, observing = 0;  // medians
};

void take_step(Simulation& simulation, StageListener* listener) {
  if (io::interrupted()) throw io::Failure(io::ExitCode::interrupted, "interrupted");
  const Status status = simulation.step(listener);
  if (!status.ok()) throw io::Failure(io::ExitCode::bad_numbers, status.message());
}

Costs measure(const ExplainOptions& options, const Params& params) {
  Simulation simulation(params);
  simulation.set_threads(threads(options));
  {
    io::Progress progress("settle", options.after, options.common.quiet);
    while (simulation.steps_done() < options.after) {
      take_step(simulation, nullptr);
      progress.update(simulation.steps_done());
    }
  }
  Costs costs;
  costs.threads = threads(options);
  costs.first = simulation.steps_done() + 1;
  std::vector<double> steps, observing;
  Observer observer(simulation);
  const Clock::time_point begin = Clock::now();
  // One step is timed by stage, the next as a whole, which is faster.
  while (steps.size() < kMeasuredSteps / 2 &&
         (steps.empty() || Clock::now() - begin < kMeasuringTime)) {
    take_step(simulation, &costs.stages);
    observer.observe(simulation);
    const Clock::time_point before_step = Clock::now();
    take_step(simulation, nullptr);
    steps.push_back(report::microseconds_since(before_step));
    const Clock::time_point before_observing = Clock::now();
    observer.observe(simulation);
    observing.push_back(report::microseconds_since(before_observing));
  }
  costs.last = simulation.steps_done();
  costs.step = report::median(steps);
  costs.observing = report::median(observing);
  return costs;
}

std::string microseconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%9.2f", value);
  return text;
}

std::string costs_words(const Costs& costs, const Params& params) {
  char text[500];
  std::snprintf(text, sizeof text,
                "Times are medians over steps %lld to %lld of this scene, measured just now, %s.\n"
                "Every second step is timed as a whole, which can take less time than the sum of "
                "its stages.\n"
                "At that rate its %lld steps take %.3g s; observing each of them adds %.3g s.\n",
                static_cast<long long>(costs.first), static_cast<long long>(costs.last),
                report::threads_words(costs.threads).c_str(), static_cast<long long>(params.steps),
                1e-6 * costs.step * static_cast<double>(params.steps),
                1e-6 * costs.observing * static_cast<double>(params.steps));
  return text;
}

/// A row of the table, its reason on as many lines as it takes.
void add_row(std::vector<io::Row>& rows, io::Row row, const std::string& reason) {
  constexpr std::size_t kReasonWidth = 38;  // with the columns before it 100 characters
  for (const std::string& line : io::wrapped(reason, kReasonWidth)) {
    row.push_back(line);
    rows.push_back(row);
    row = {"", "", "", ""};
  }
}

std::string scene_words(const io::Setup& setup) {
  std::string text = setup.title.empty() ? "" : setup.title + "\n";
  if (!setup.description.empty()) text += setup.description + "\n";
  return text + litter_words(setup.params) + "\n\n";
}

std::string explanation(const io::Setup& setup, const Costs& costs) {
  double stages = 0;
  for (int i = 0; i < kStageCount; ++i) stages += costs.stages.median(static_cast<Stage>(i));
  std::vector<io::Row> rows{{"stage", "in the step", "µs a step", "of the step", "why"}};
  for (const Decision& decision : explain_plan(setup.params, kContactRecords)) {
    const std::string nothing = std::string(8, ' ') + "-";
    if (decision.part) {
      if (decision.needed) continue;  // its time is in that of its stage
      add_row(rows, {"- " + std::string(part_name(*decision.part)), "no", nothing, ""},
              decision.reason);
      continue;
    }
    const double cost = costs.stages.median(decision.stage);
    add_row(rows,
            {std::string(stage_name(decision.stage)), decision.needed ? "yes" : "no",
             decision.needed ? microseconds(cost) : nothing, io::bar(cost, stages)},
            decision.reason);
  }
  rows.push_back({"whole step", "", microseconds(costs.step)});
  add_row(
      rows,
      {"observables", "on demand", microseconds(costs.observing), io::bar(costs.observing, stages)},
      "only after steps that are observed");
  return scene_words(setup) + io::aligned(rows) + "\n" + costs_words(costs, setup.params);
}

std::string explanation_json(const io::Setup& setup, const Costs& costs) {
  std::vector<std::string> stages;
  for (const Decision& decision : explain_plan(setup.params, kContactRecords)) {
    io::JsonObject row{{"stage", io::json_string(stage_name(decision.stage))}};
    if (decision.part) row.emplace_back("part", io::json_string(part_name(*decision.part)));
    row.emplace_back("needed", io::json_bool(decision.needed));
    if (!decision.part && decision.needed) {
      row.emplace_back("microseconds", io::json_number(costs.stages.median(decision.stage)));
    }
    row.emplace_back("reason", io::json_string(decision.reason));
    stages.push_back(io::json_object(row));
  }
  return io::json_file({{"title", io::json_string(setup.title)},
                        {"threads", std::to_string(costs.threads)},
                        {"first_step", std::to_string(costs.first)},
                        {"last_step", std::to_string(costs.last)},
                        {"stages", io::json_array(stages)},
                        {"step_microseconds", io::json_number(costs.step)},
                        {"observing_microseconds", io::json_number(costs.observing)}});
}

/// With the left-out parts forced in.
void compare(const ExplainOptions& options, const io::Setup& setup) {
  report::MeasuredSteps steps;
  steps.after = options.after;
  steps.threads = threads(options);
  steps.count = kMeasuredSteps;
  steps.quiet = options.common.quiet;
  const report::Savings savings = report::measure_savings(setup.params, steps);
  std::string text = scene_words(setup) + io::aligned(report::savings_rows(savings));
  for (const std::string& note : report::savings_notes(savings)) {
    constexpr std::size_t kPageWidth = 100;
    text += "\n";
    for (const std::string& line : io::wrapped(note, kPageWidth)) text += line + "\n";
  }
  deliver(options.common, text);
  report::require_same_bits(savings);
}

void work(const ExplainOptions& options) {
  const io::Setup setup = io::set_up(options.common.settings);
  const Common& common = options.common;
  if (!common.out.empty()) io::refuse_existing(common.out, common.force);
  if (options.json) {
    if (options.measure) io::refuse("--json and --measure do not go together; leave one out");
    deliver(options.common, explanation_json(setup, measure(options, setup.params)));
  } else if (options.measure) {
    compare(options, setup);
  } else {
    deliver(options.common, explanation(setup, measure(options, setup.params)));
  }
}

}  // namespace

Verb add_explain(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "explain", "Show which stages a scene needs and why, and the time of each");
  const auto options = std::make_shared<ExplainOptions>();
  CommonHelp help;
  help.threads = "Threads that share a step (default 1)";
  help.out = "Write the explanation to a file instead of standard output";
  help.quiet = "No progress";
  add_common(*app, options->common, help);
  app->add_option(
         "--after", options->after,
         "Run N steps before measuring, since the time of contacts depends on what touches "
         "(default 300)")
      ->option_text("N")
      ->check(between(std::int64_t{0}, kUnbounded));
  add_json(*app, options->json);
  app->add_flag("--measure", options->measure,
                "Also run with each part that the scene leaves out, show the time that leaving it "
                "out saves, and check that no bit of the results differs");
  return {app,
          [options] { work(*options); },
          {{"explain", "The stages of the paper's litter and their times"},
           {"explain single --measure", "What leaving out saves for a single pup"}}};
}

}  // namespace pupflow::cli
