// pupflow sweep, figure2, merge and compare: many runs, their files and figures.
#include <algorithm>
#include <memory>
#include <thread>

#include "app/cli/parse.h"
#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/study/compare.h"
#include "app/study/sweep.h"
#include "app/study/transition.h"

namespace pupflow::cli {
namespace {

struct Options {
  Common common;  // its `out` is the folder
  std::vector<std::string> vary;
  std::int64_t seeds = 10;
  std::string shard = "1/1";
};

int thread_count(const Common& common) {
  if (common.threads > 0) return common.threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

study::Design design_of(const Options& options, const std::string& name) {
  study::Design design;
  design.name = name;
  design.base = io::set_up(options.common.settings).params;
  for (const std::string& axis : options.vary) design.axes.push_back(study::parse_axis(axis));
  design.seeds = options.seeds;
  design.shard = study::parse_shard(options.shard);
  return design;
}

/// What a finished sweep says at its end, and its failure if runs went wrong.
void report(const study::Design& design, const study::SweepResult& result,
            const std::string& folder, bool quiet) {
  std::string text;
  if (result.resumed > 0) text += std::to_string(result.resumed) + " runs were there already\n";
  text += std::to_string(result.rows.size()) + " runs in " + study::runs_path(folder) + "\n";
  if (!result.summaries.empty()) {
    text += "means of " + std::to_string(result.summaries.size()) + " points in " +
            study::summary_path(folder) + "\n";
    if (result.note.empty()) text += "figure in " + folder + "/" + design.name + ".png and .svg\n";
    const auto transition = study::find_transition(design, result.summaries);
    if (transition) text += study::transition_text(design, *transition);
  }
  if (!result.note.empty()) text += result.note + "\n";
  if (!quiet) io::print(text);
  const std::string failures = study::failures_text(design, result.rows);
  if (!failures.empty()) throw io::Failure(io::ExitCode::bad_numbers, failures);
}

void work(const Options& options, const std::string& name) {
  study::SweepJob job;
  job.design = design_of(options, name);
  job.folder = options.common.out.empty() ? name : options.common.out;
  job.threads = thread_count(options.common);
  job.force = options.common.force;
  job.quiet = options.common.quiet;
  report(job.design, study::run_sweep(job), job.folder, job.quiet);
}

void add_sweep_options(CLI::App& app, Options& options, const std::string& folder) {
  CommonHelp help;
  help.settings = "seed is the base seed, from which every run's own is made";
  help.threads = "Runs at a time (default: all cores); changes no byte of any file";
  help.out =
      "The folder for runs.csv, summary.csv, manifest.toml and the figure (default " + folder + ")";
  help.quiet = "No progress and no summary at the end";
  add_common(app, options.common, help);
  app.add_option("--seeds", options.seeds, "Runs at each point (default 10)")
      ->option_text("N")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1000000}));
  app.add_option("--shard", options.shard,
                 "Compute only every n-th run, from the i-th on; 'pupflow merge' joins all n")
      ->option_text("i/n")
      ->check(not_empty);
  app.footer(
      "Finished runs are kept: after Ctrl-C, a full disk or a crash the same command goes on where "
      "it\n"
      "stopped. It refuses a folder that holds another sweep. Exit code 3 when the numbers of a "
      "run went\n"
      "wrong: its row says where, and it is left out of the means.");
}

struct MergeOptions {
  std::vector<std::string> folders;
  std::string out;
  bool force = false, quiet = false;
};

void merge(const MergeOptions& options) {
  const study::SweepResult result =
      study::merge_shards(options.folders, options.out, options.force);
  report(study::design_of_folder(options.out), result, options.out, options.quiet);
}

}  // namespace

Verb add_sweep(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("sweep", "Run any parameters over a range, with many seeds");
  const auto options = std::make_shared<Options>();
  add_sweep_options(*app, *options, "sweep");
  app->add_option(
         "--vary", options->vary,
         "Vary a parameter: name=from:to:count or name=a,b,c; repeat it for a grid. One gives\n"
         "four panels, two give maps, more give the CSV files only")
      ->option_text("RANGE")
      ->allow_extra_args(false)
      ->take_all()
      ->required();
  return {app, [options] { work(*options, "sweep"); }};
}

Verb add_figure2(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "figure2", "The paper's Figure 2: 24 ambient temperatures, 10 seeds each");
  const auto options = std::make_shared<Options>();
  add_sweep_options(*app, *options, "figure2");
  options->vary = {"ta=0:1:24"};
  return {app, [options] { work(*options, "figure2"); }};
}

Verb add_merge(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("merge", "Join the shards of a sweep, checked to be complete");
  const auto options = std::make_shared<MergeOptions>();
  app->add_option("FOLDER", options->folders, "The shards' folders")->option_text(" ")->required();
  app->add_option("--out", options->out, "The folder for the whole")
      ->option_text("FOLDER")
      ->required()
      ->check(not_empty);
  app->add_flag("--force", options->force, "Replace another sweep there");
  app->add_flag("--quiet", options->quiet, "No summary at the end");
  return {app, [options] { merge(*options); }};
}

Verb add_compare(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("compare", "Hold two sweeps' summaries against each other");
  const auto paths = std::make_shared<std::vector<std::string>>();
  app->add_option("SUMMARY", *paths, "Two summary.csv files of the same points")
      ->option_text(" ")
      ->required()
      ->expected(2);
  app->footer(
      "Differences of the means, in units of their combined standard error: sd / sqrt(runs) of "
      "both.");
  return {app, [paths] {
            io::print(study::comparison_text(study::compare_summaries((*paths)[0], (*paths)[1])));
          }};
}

}  // namespace pupflow::cli
