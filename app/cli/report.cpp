// pupflow report: measurements of the program and the model.
#include <memory>

#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/nearest.h"
#include "app/io/text.h"
#include "app/report/error/error.h"
#include "app/report/error/own_run.h"
#include "app/report/stability/stability.h"
#include "app/report/validation/validation.h"

namespace pupflow::cli {
namespace {

/// One kind of report, by the word that asks for it.
struct Kind {
  const char* name;
  void (*make)(const report::Options&);
  report::OwnAnswer (*make_own)(const report::Options&, const report::OwnRun&) = nullptr;
};

constexpr Kind kKinds[] = {{"error", report::report_error, report::report_own_error},
                           {"stability", report::report_stability},
                           {"validation", report::report_validation}};

struct ReportOptions {
  std::string kind;
  Common common;  // its `out` is the folder
  std::vector<std::string> observables;
  std::int64_t seeds = 0;  // 0: not given
  bool quick = false;
};

const Kind& kind_named(const std::string& name) {
  std::vector<std::string_view> names;
  std::string listed;
  for (const Kind& kind : kKinds) {
    if (name == kind.name) return kind;
    names.emplace_back(kind.name);
    listed += (listed.empty() ? "" : ", ") + std::string(kind.name);
  }
  if (name.empty()) {
    throw io::Failure(io::ExitCode::bad_input, "report: KIND is missing; it is one of " + listed);
  }
  const std::string meant = io::did_you_mean(name, names);
  throw io::Failure(io::ExitCode::bad_input, "unknown report " + io::quoted(name) +
                                                 (meant.empty() ? "; there are " + listed : meant));
}

/// A word, quoted where a shell needs that.
std::string shell_word(const std::string& word) {
  const bool plain = word.find_first_not_of(
                         "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                         "0123456789_-+=.,:/%@") == std::string::npos;
  if (plain && !word.empty()) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

/// The command that makes the same report.
std::string command_of(const ReportOptions& options) {
  std::string command = "pupflow report " + options.kind;
  const auto add = [&](const std::string& option, const std::string& value) {
    command += (option.empty() ? " " : " " + option + " ") + shell_word(value);
  };
  const io::Settings& settings = options.common.settings;
  if (!settings.scene.empty()) add("", settings.scene);
  if (!settings.like.empty()) add("--like", settings.like);
  for (const std::string& set : settings.sets) add("--set", set);
  for (const std::string& change : settings.at) add("--at", change);
  if (settings.seed) add("--seed", *settings.seed);
  if (settings.steps) add("--steps", *settings.steps);
  if (settings.precision) add("--precision", *settings.precision);
  for (const std::string& name : options.observables) add("--observable", name);
  if (options.seeds > 0) add("--seeds", std::to_string(options.seeds));
  return command + (options.quick ? " --quick" : "");
}

report::Options settings_of(const ReportOptions& options) {
  report::Options settings;
  settings.folder = options.common.out.empty() ? "report-" + options.kind : options.common.out;
  settings.command = command_of(options);
  settings.threads = thread_count(options.common);
  settings.quick = options.quick;
  settings.force = options.common.force;
  settings.quiet = options.common.quiet;
  return settings;
}

void work(const ReportOptions& options) {
  const Kind& kind = kind_named(options.kind);
  const report::Options settings = settings_of(options);
  const std::string where = "report in " + settings.folder + "/report.md\n";
  const bool own = !options.common.settings.empty();
  if (!own && (options.seeds > 0 || !options.observables.empty())) {
    throw io::Failure(
        io::ExitCode::bad_input,
        "--seeds and --observable need a run of your own; name its scene, e.g. 'pupflow "
        "report error paper --seeds 10'");
  }
  if (!own) {
    kind.make(settings);
    if (!settings.quiet) io::print(where);
    return;
  }
  if (kind.make_own == nullptr) {
    throw io::Failure(io::ExitCode::bad_input,
                      "report " + options.kind +
                          " has its own scenes; only 'report error' takes a scene or settings");
  }
  const io::Setup setup = io::set_up(options.common.settings);
  const report::OwnAnswer answer =
      kind.make_own(settings, {setup.params, setup.title, options.seeds, options.observables});
  if (!settings.quiet) io::print(answer.words + where);
  if (!answer.failures.empty()) {
    throw io::Failure(io::ExitCode::bad_numbers, answer.failures);
  }
}

}  // namespace

Verb add_report(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "report",
      "Measure the program, the model or a run of your own: error and run time, stability, "
      "validation");
  const auto options = std::make_shared<ReportOptions>();
  app->add_option("KIND", options->kind,
                  "error: error against run time, of test scenes or of SCENE; stability: maps of "
                  "where the method is stable, and extreme scenes; validation: measurements of the "
                  "model, to compare with the paper")
      ->option_text(" ");
  CommonHelp help;
  help.settings = "only with 'error'";
  help.threads = "Runs at a time, where they are not timed (default: all cores)";
  help.out = "The folder for report.md, figures and CSV files (default report-KIND)";
  help.quiet = "No progress and no summary";
  add_common(*app, options->common, help);
  app->get_option("--out")->option_text("FOLDER");
  app->add_flag("--quick", options->quick, "Fewer settings and seeds, and shorter runs");
  app->add_option("--observable", options->observables,
                  "With 'error SCENE': the mean to report, a column of a sweep; repeatable "
                  "(default huddling and mean_tb)")
      ->option_text("STATISTIC")
      ->allow_extra_args(false)
      ->take_all();
  app->add_option("--seeds", options->seeds,
                  "With 'error SCENE': runs of each setting (default 20, or 5 with --quick)")
      ->option_text("N")
      ->check(between(std::int64_t{2}, std::int64_t{1000000}));
  app->footer(
      "'report error SCENE' (or --set, --like) reports the error of that run, and how it changes "
      "with half or twice the time: the same seeds with other time steps, points, precision, run "
      "lengths and windows. Exit code 3: a run of the scene itself failed. A report has the times "
      "of this machine, so close other programs while it is made.");
  return {app,
          [options] { work(*options); },
          {{"report error --quick", "Error against run time of the test scenes"},
           {"report error cold --seeds 10", "The error of a run of your own"}}};
}

}  // namespace pupflow::cli
