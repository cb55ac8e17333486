// pupflow run: steps without any graphics.
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "app/cli/outputs.h"
#include "app/cli/start.h"
#include "app/cli/summary.h"
#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/io/checkpoint.h"
#include "app/io/csv.h"
#include "app/io/failure.h"
#include "app/io/interrupt.h"
#include "app/io/progress.h"
#include "app/io/provenance.h"
#include "app/io/recording.h"
#include "app/io/unfinished.h"
#include "pupflow/observer.h"
#include "pupflow/overlap.h"
#include "pupflow/simulation.h"

namespace pupflow::cli {
namespace {

struct RunOptions {
  Common common;  // its `out` is the metrics CSV
  std::string pups, record, checkpoint, from;
  std::int64_t every = 1, record_every = 10;
  std::optional<std::int64_t> checkpoint_every;
  std::optional<std::int64_t> record_from;
  std::string record_fields = "pup";
  bool overlap = false;
  bool json = false;
  bool celsius = false;
};

/// The files that were asked for. They appear when the run ends, however it ends.
struct Files {
  std::optional<io::MetricsCsv> metrics;
  std::optional<io::PupsCsv> pups;
  std::optional<io::Recording> recording;
  PartSet recorded;  // what its frames need

  Files(const RunOptions& options, const Simulation& start) {
    if (!options.common.out.empty()) {
      metrics.emplace(options.common.out, options.common.force, start);
    }
    if (!options.pups.empty()) pups.emplace(options.pups, options.common.force, start);
    if (!options.record.empty()) {
      const io::RecordedFields fields = io::parse_recorded_fields(options.record_fields);
      recording.emplace(options.record, options.common.force, start.recipe(), io::provenance(start),
                        fields);
      recorded = fields.parts();
    }
    if (options.checkpoint.empty()) return;
    io::refuse_stream(options.checkpoint);
    io::refuse_existing(options.checkpoint, options.common.force);
  }

  void finish(const Simulation& litter, const std::string& ending) {
    io::TextEntries state;
    io::add_state(litter, state);
    const auto close = [&](io::CsvFile& file) {
      for (const auto& [name, value] : state) file.comment(name + " = " + value);
      for (const Warning& warning : litter.warnings())
        file.comment("warning: " + warning.message());
      if (!ending.empty()) file.comment("ended early: " + ending);
      file.commit();
    };
    if (metrics) close(metrics->file());
    if (pups) close(pups->file());
    if (!recording) return;
    for (const auto& [name, value] : state) {
      if (name != "edited") recording->note(name, value);  // it is there from the start
    }
    recording->commit(ending);
  }
};

/// What is looked at before anything is opened.
void check_outputs(const CLI::App& verb, const RunOptions& options) {
  for (const char* option : {"--record-every", "--record-from", "--record-fields"}) {
    refuse_idle(verb, option, !options.record.empty(), "--record FILE");
  }
  refuse_idle(verb, "--checkpoint-every", !options.checkpoint.empty(), "--checkpoint FILE");
  refuse_idle(verb, "--every", !options.common.out.empty() || !options.pups.empty(),
              "--csv FILE or --pups FILE");
  refuse_idle(verb, "--overlap", options.json || !options.common.quiet,
              "the summary, which --quiet leaves out");
  refuse_idle(verb, "--celsius", !options.json && !options.common.quiet,
              "a summary for people; JSON has the model's units");
  const std::string paths[] = {options.common.out, options.pups, options.record,
                               options.checkpoint};
  refuse_same_file({{"--csv", paths[0]},
                    {"--pups", paths[1]},
                    {"--record", paths[2]},
                    {"--checkpoint", paths[3]}});
  io::name_unfinished(paths);
}

/// One run: steps, and looks at the litter only where somebody asked for what is seen.
class Run {
 public:
  Run(const RunOptions& options, Simulation start)
      : options_(options),
        files_(options, start),
        simulation_(std::move(start)),
        means_(simulation_.params().discard),
        summary_(options.json || !options.common.quiet) {
    simulation_.set_threads(thread_count(options.common));
    if (options.overlap && summary_) overlap_.emplace();
  }

  /// Steps to the end, a bad status, or Ctrl-C; then puts the files in place.
  void go() {
    const auto start = std::chrono::steady_clock::now();
    const std::int64_t steps = simulation_.params().steps;
    io::Progress progress("run", steps, options_.common.quiet);
    record_start();
    while (simulation_.steps_done() < steps && simulation_.status().ok() && !io::interrupted()) {
      one_step();
      const bool due = options_.checkpoint_every && simulation_.status().ok() &&
                       simulation_.steps_done() % *options_.checkpoint_every == 0;
      if (due) keep_state();
      progress.update(simulation_.steps_done());
    }
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    files_.finish(simulation_, ending());
    if (!options_.checkpoint.empty() && simulation_.status().ok()) keep_state();
  }

  /// Why the run ended before its last step; empty when it did not.
  std::string ending() const {
    if (!simulation_.status().ok()) return simulation_.status().message();
    if (simulation_.steps_done() == simulation_.params().steps) return {};
    return "interrupted after step " + std::to_string(simulation_.steps_done());
  }

  bool summary() const { return summary_; }
  const Simulation& simulation() const { return simulation_; }
  const RunMeans& means() const { return means_; }
  std::optional<Overlap> overlap() const {
    return overlap_ ? std::optional(overlap_->means.means()) : std::nullopt;
  }
  double seconds() const { return seconds_; }

 private:
  bool in_means(std::int64_t step) const { return summary_ && step > simulation_.params().discard; }

  /// Whether the observables after `step` are wanted, or those up to `ahead` steps later.
  bool wanted(std::int64_t step, std::int64_t ahead = 0) const {
    const bool row =
        files_.metrics && (step + ahead) / options_.every > (step - 1) / options_.every;
    return row || in_means(step + ahead);
  }

  /// Whether the state after `step` is a frame of the recording.
  bool frame_at(std::int64_t step) const {
    const std::int64_t from = options_.record_from.value_or(options_.record_every);
    return files_.recording && step >= from && (step - from) % options_.record_every == 0;
  }

  /// The state that the run begins with is a frame only where --record-from asks for it.
  void record_start() {
    if (!options_.record_from || !frame_at(simulation_.steps_done())) return;
    simulation_.set_observed(observed_ = files_.recorded);
    files_.recording->add(simulation_);
  }

  /// Writes the checkpoint, in place of the one of an earlier step.
  void keep_state() {
    if (kept_ == simulation_.steps_done()) return;
    io::write_checkpoint(options_.checkpoint, options_.common.force || kept_, simulation_);
    kept_ = simulation_.steps_done();
  }

  void one_step() {
    const std::int64_t step = simulation_.steps_done() + 1, lag = simulation_.params().flow_lag;
    const bool observe = wanted(step), later = wanted(step, lag);
    const bool pups_row = files_.pups && step % options_.every == 0;
    const bool frame = frame_at(step);
    if (!later) observer_.reset();
    // The state before a step that is compared with a later one, as the last step left it.
    if (later && !observer_ && wanted(step - 1, lag)) observer_.emplace(simulation_);
    // A checkpoint holds who touches whom: the run that goes on from it compares with that.
    const bool contacts = later || !options_.checkpoint.empty();
    const PartSet parts = (contacts ? kContactRecords : PartSet{}) |
                          (pups_row ? parts_in_files() : PartSet{}) |
                          (frame ? files_.recorded : PartSet{});
    if (parts != observed_) simulation_.set_observed(observed_ = parts);
    if (!simulation_.step().ok()) return;
    if (observe) {
      observer_->observe(simulation_);
    } else if (observer_) {
      observer_->pass(simulation_);
    }
    if (in_means(step)) means_.add(simulation_, observer_->last());
    if (overlap_ && in_means(step) &&
        (step - simulation_.params().discard - 1) % kOverlapEvery == 0)
      overlap_->means.add(overlap_->meter.measure(simulation_));
    if (observe && files_.metrics && step % options_.every == 0)
      files_.metrics->add(simulation_, observer_->last());
    if (pups_row) files_.pups->add(simulation_);
    if (frame) files_.recording->add(simulation_);
  }

  const RunOptions& options_;
  Files files_;
  Simulation simulation_;
  std::optional<Observer> observer_;
  PartSet observed_ = kContactRecords;  // as a new simulation has it
  RunMeans means_;
  std::optional<std::int64_t> kept_;  // the step of the checkpoint that is there
  bool summary_;
  struct OverlapLooks {
    OverlapMeter meter;
    OverlapMeans means;
  };
  std::optional<OverlapLooks> overlap_;
  double seconds_ = 0;
};

void work(const CLI::App& verb, const RunOptions& options) {
  check_outputs(verb, options);
  const Start start = start_of(options.common.settings, options.from);
  Run run(options, litter_of(start));
  run.go();
  if (run.summary()) {
    const Seen seen{run.means(), run.overlap()};
    const std::string text =
        options.json
            ? run_json(start.title, run.simulation(), seen, run.seconds())
            : run_summary(start.title, run.simulation(), seen, run.seconds(), options.celsius);
    const bool taken =
        io::is_standard_output(options.common.out) || io::is_standard_output(options.pups);
    if (taken) {
      std::fputs(text.c_str(), stderr);
    } else {
      io::print(text);
    }
  }
  const std::string ending = run.ending();
  if (ending.empty()) return;
  const bool bad = !run.simulation().status().ok();
  throw io::Failure(bad ? io::ExitCode::bad_numbers : io::ExitCode::interrupted, ending);
}

}  // namespace

Verb add_run(CLI::App& program) {
  CLI::App* app = program.add_subcommand("run", "Step a scene without graphics; write CSV files");
  const auto options = std::make_shared<RunOptions>();
  CommonHelp help;
  help.threads =
      "Threads that share a step (default: all cores, where the litter is large enough); changes "
      "no bit of the result";
  help.out_names = "-o,--csv,--out";
  help.out = "Write the litter's observables, a row a step ('-' for standard output)";
  help.quiet = "No summary at the end and no progress";
  add_common(*app, options->common, help);
  app->add_option("--pups", options->pups,
                  "Write each pup's state, a row a pup and step ('-' for standard output)")
      ->option_text("FILE")
      ->check(not_empty);
  app->add_option("--every", options->every, "Rows for steps N, 2N, ... only (default 1)")
      ->option_text("N")
      ->check(between(std::int64_t{1}, kUnbounded));
  app->add_option("--record", options->record,
                  "Write the litter's fields at chosen steps to an HDF5 file")
      ->option_text("FILE")
      ->check(not_empty);
  app->add_option("--record-every", options->record_every, "A frame every N steps (default 10)")
      ->option_text("N")
      ->check(between(std::int64_t{1}, kUnbounded));
  app->add_option("--record-from", options->record_from,
                  "Step of the first frame, 0 for the start (default: N of --record-every)")
      ->option_text("STEP")
      ->check(between(std::int64_t{0}, kUnbounded));
  app->add_option("--record-fields", options->record_fields,
                  "What a frame holds: pup, afferent, point (groups), or names of 'pupflow fields' "
                  "(default pup)")
      ->option_text("FIELD,...")
      ->check(not_empty);
  app->add_option("--checkpoint", options->checkpoint,
                  "Write the whole state at the end (also after Ctrl-C) to an HDF5 file")
      ->option_text("FILE")
      ->check(not_empty);
  app->add_option("--checkpoint-every", options->checkpoint_every,
                  "Write it every N steps, too, each in place of the one before")
      ->option_text("N")
      ->check(between(std::int64_t{1}, kUnbounded));
  add_from(*app, options->from);
  add_flow_lag(*app, options->common);
  add_json(*app, options->json);
  add_celsius(*app, options->celsius);
  app->add_flag("--overlap", options->overlap,
                "Tell in the summary how far bodies run into each other: means over every " +
                    std::to_string(kOverlapEvery) + "th of the steps of the other means");
  app->footer(
      "Exit code 3 when the numbers went wrong, 130 after Ctrl-C: the rows up to there are kept, "
      "and "
      "a last comment line says why they end. Until the run ends a file is called "
      "FILE.PROCESS.unfinished; after a kill 'pupflow info', 'export' and 'verify' read what a "
      "recording had.");
  return {app,
          [options, app] { work(*app, *options); },
          {{"run cold --csv cold.csv", "A shipped scene, a row of observables a step"},
           {"run --set ta=0.2 --seed 7 --steps 3000 --record run.h5",
            "A litter of your own, recorded"}}};
}

}  // namespace pupflow::cli
