// pupflow explain: which stages a scene needs, why, and what each costs here and now.
#include <cstdio>
#include <memory>

#include "app/cli/stage_timer.h"
#include "app/cli/summary.h"
#include "app/cli/verb.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/progress.h"
#include "app/io/table.h"
#include "engine/metrics.h"
#include "engine/plan.h"

namespace pupflow::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMeasuredSteps = 200;
constexpr std::chrono::seconds kPatience{5};  // for measuring, whatever the size of the scene

struct Options {
  Common common;
  std::int64_t after = 300;
};

/// What was measured; microseconds.
struct Costs {
  std::int64_t first = 0, last = 0;  // the steps that it was measured over
  StageTimer stages;
  double step = 0, observing = 0;  // medians
};

double microseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

void take_step(Simulation& simulation, StageListener* listener) {
  if (io::interrupted()) throw io::Failure(io::ExitCode::interrupted, "interrupted");
  const Status status = simulation.step(listener);
  if (!status.ok()) throw io::Failure(io::ExitCode::bad_numbers, status.message());
}

Costs measure(const Options& options, const Params& params) {
  Simulation simulation(params);
  {
    io::Progress progress("settle", options.after, options.common.quiet);
    while (simulation.steps_done() < options.after) {
      take_step(simulation, nullptr);
      progress.update(simulation.steps_done());
    }
  }
  Costs costs;
  costs.first = simulation.steps_done() + 1;
  std::vector<double> steps, observing;
  Observer observer(simulation);
  const Clock::time_point begin = Clock::now();
  while (steps.size() < kMeasuredSteps && (steps.empty() || Clock::now() - begin < kPatience)) {
    const Clock::time_point before_step = Clock::now();
    take_step(simulation, &costs.stages);
    steps.push_back(microseconds_since(before_step));
    const Clock::time_point before_look = Clock::now();
    observer.observe(simulation);
    observing.push_back(microseconds_since(before_look));
  }
  costs.last = simulation.steps_done();
  costs.step = median(steps);
  costs.observing = median(observing);
  return costs;
}

std::string microseconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string costs_words(const Costs& costs, const Params& params) {
  char text[400];
  std::snprintf(
      text, sizeof text,
      "Times are medians over steps %lld to %lld of this scene, measured just now on this "
      "machine, one thread.\nAt that rate its %lld steps take %.3g s; observing each of "
      "them would add %.3g s.\n",
      static_cast<long long>(costs.first), static_cast<long long>(costs.last),
      static_cast<long long>(params.steps), 1e-6 * costs.step * static_cast<double>(params.steps),
      1e-6 * costs.observing * static_cast<double>(params.steps));
  return text;
}

std::string explanation(const io::Setup& setup, const Costs& costs) {
  std::vector<io::Row> rows{{"stage", "in the step", "µs a step", "why"}};
  for (const PlannedStage& planned : explain_plan(setup.params, true)) {
    const double cost = costs.stages.median(planned.stage);
    rows.push_back({std::string(stage_name(planned.stage)), planned.needed ? "yes" : "no",
                    planned.needed ? microseconds(cost) : "-", planned.reason});
  }
  rows.push_back({"whole step", "", microseconds(costs.step), ""});
  rows.push_back({"observables", "on demand", microseconds(costs.observing),
                  "only after steps whose row or mean somebody asked for"});
  std::string text = setup.title.empty() ? "" : setup.title + "\n";
  if (!setup.description.empty()) text += setup.description + "\n";
  text += litter_words(setup.params) + "\n\n" + io::aligned(rows) + "\n";
  return text + costs_words(costs, setup.params);
}

void work(const Options& options) {
  const io::Setup setup = io::set_up(options.common.settings);
  deliver(options.common, explanation(setup, measure(options, setup.params)));
}

}  // namespace

Verb add_explain(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "explain", "Tell which stages a scene needs and why, and what each costs");
  const auto options = std::make_shared<Options>();
  CommonHelp help;
  help.threads = "Accepted everywhere; one thread is measured";
  help.out = "Write the explanation to a file instead of standard output";
  help.quiet = "No progress";
  add_common(*app, options->common, help);
  app->add_option("--after", options->after,
                  "Let the litter fall for N steps before measuring, since contacts cost what "
                  "touches (default 300)")
      ->option_text("N")
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1} << 53));
  return {app, [options] { work(*options); }};
}

}  // namespace pupflow::cli
