#include "app/cli/sweep_work.h"

#include <filesystem>
#include <memory>

#include "app/cli/launcher.h"
#include "app/cli/summary.h"
#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/study/files.h"
#include "app/study/latin.h"
#include "app/study/series.h"
#include "app/study/table.h"
#include "app/study/transition.h"

namespace pupflow::cli {
namespace {

int threads_of_rank(const Common& common, const mpi::RankInfo& self) {
  if (self.size > 1 && common.threads == 0) return 1;  // launchers start one rank per core
  return thread_count(common);
}

/// Gives the design the points that were asked for; needs its base.
void choose_points(const SweepOptions& options, study::Design& design) {
  if (!options.design.empty()) {
    if (!options.vary.empty() || options.lhs)
      io::refuse("--design " + options.design +
                 ": its rows are all points; leave out --vary and --lhs");
    study::read_table(options.design, design);
    if (!design.given_seeds.empty() && options.seeds)
      io::refuse("--seeds: the column seed of " + options.design + " has the seed of each run");
    return;
  }
  if (options.vary.empty())
    io::refuse("say what varies: --vary RANGE, or --design FILE; see 'pupflow sweep --help'");
  if (!options.lhs) {
    for (const std::string& axis : options.vary) design.axes.push_back(study::parse_axis(axis));
    return;
  }
  std::vector<study::Span> spans;
  for (const std::string& span : options.vary) spans.push_back(study::parse_span(span));
  study::spread_latin(design, spans, *options.lhs);
}

study::Design design_of(const SweepOptions& options, const std::string& name) {
  study::Design design;
  design.name = name;
  design.base = io::set_up(options.common.settings).params;
  choose_points(options, design);
  if (options.seeds) design.seeds = *options.seeds;
  if (options.record) design.record_every = options.every;
  design.shard = study::parse_shard(options.shard);
  return design;
}

}  // namespace

void add_plot_script(CLI::App& app, std::string& script) {
  app.add_option("--plot-script", script,
                 "Draw the figure with this gnuplot script: the one in the folder after you edited "
                 "it, or another. A script can do whatever a program can, so an edited one is run "
                 "only where it is named here")
      ->option_text("FILE")
      ->check(not_empty);
}

void check_plot_script(const std::string& script) {
  std::error_code ignored;
  if (script.empty() || std::filesystem::is_regular_file(script, ignored)) return;
  throw io::Failure(io::ExitCode::bad_file, "--plot-script " + script + ": there is no such file");
}

void add_sweep_options(CLI::App& app, SweepOptions& options, const std::string& folder) {
  CommonHelp help;
  help.settings = "seed is the base seed, from which the seed of each run is made";
  help.threads =
      "Runs at a time (default: all cores; under MPI 1 per rank); the files do not depend on it";
  help.out =
      "The folder for runs.csv, summary.csv, manifest.toml and the figure (default " + folder + ")";
  help.quiet = "No progress and no summary at the end";
  add_common(app, options.common, help);
  app.get_option("--out")->option_text("FOLDER");
  add_flow_lag(app, options.common);
  app.add_option("--seeds", options.seeds,
                 "Runs at each point (default 10); with a larger N than before only the new ones "
                 "are computed")
      ->option_text("N")
      ->check(between(std::int64_t{1}, std::int64_t{1000000}));
  app.add_option(
         "--shard", options.shard,
         "Compute only every n-th run, from the i-th on; 'pupflow merge' joins all n shards")
      ->option_text("i/n")
      ->check(not_empty);
  app.add_flag(
      "--record", options.record,
      "Also keep the time series of each run, series/P-S.csv for point P and its seed number S");
  app.add_option("--every", options.every, "Rows of the series for steps N, 2N, ... (default 1)")
      ->option_text("N")
      ->check(between(std::int64_t{1}, kUnbounded));
  add_plot_script(app, options.plot_script);
  add_celsius(app, options.celsius);
  app.footer(
      "Finished runs are kept. After Ctrl-C, a full disk or a crash, the same command computes the "
      "missing runs. A folder that holds another sweep, or in which another process is at work, is "
      "refused. Exit code 3: a run failed. Its row has the status, and the means leave it out.");
}

void run_sweep_verb(const CLI::App& verb, const SweepOptions& options, const std::string& name) {
  refuse_idle(verb, "--celsius", !options.common.quiet, "the summary, which --quiet leaves out");
  refuse_idle(verb, "--every", options.record, "--record");
  mpi::RankInfo self = launched_rank();
  self.threads = threads_of_rank(options.common, self);
  std::unique_ptr<study::Executor> all_ranks;
  if (self.size > 1) {
    mpi::Interface& module = load_mpi(self);
    if (self.rank > 0) return module.run_worker(self);
    all_ranks = module.start_leader(self);
  }
  check_plot_script(options.plot_script);
  study::SweepJob job;
  job.design = design_of(options, name);
  job.folder = options.common.out.empty() ? name : options.common.out;
  job.threads = self.threads;
  job.executor = all_ranks.get();
  job.force = options.common.force;
  job.quiet = options.common.quiet;
  job.plot_script = options.plot_script;
  const study::SweepResult result = study::run_sweep(job);
  report_sweep(job.design, result, job.folder, {job.quiet, options.celsius});
}

void report_sweep(const study::Design& design, const study::SweepResult& result,
                  const std::string& folder, SummaryStyle style) {
  std::string text;
  if (result.resumed > 0) text += std::to_string(result.resumed) + " runs were there already\n";
  text += std::to_string(result.rows.size()) + " runs in " + study::runs_path(folder) + "\n";
  if (!result.summaries.empty()) {
    if (design.record_every > 0) text += "series in " + study::series_folder(folder) + "\n";
    text += "means of " + std::to_string(result.summaries.size()) + " points in " +
            study::summary_path(folder) + "\n";
    if (result.note.empty()) text += "figure in " + folder + "/" + design.name + ".png and .svg\n";
    const auto transition = study::find_transition(design, result.summaries);
    if (transition) text += study::transition_text(design, *transition, style.celsius);
  }
  if (!result.note.empty()) text += result.note + "\n";
  const std::string warnings = study::warnings_text(design, result.rows);
  if (!warnings.empty()) text += "warning: " + warnings + "\n";
  if (!style.quiet) io::print(text);
  const std::string failures = study::failures_text(design, result.rows);
  if (!failures.empty()) throw io::Failure(io::ExitCode::bad_numbers, failures);
}

}  // namespace pupflow::cli
