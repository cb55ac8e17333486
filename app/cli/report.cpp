// pupflow report: what the program measures about itself.
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

struct Wishes {
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
    throw io::Failure(io::ExitCode::bad_input,
                      "report: which one? " + listed + "; see 'pupflow report --help'");
  }
  const std::string meant = io::did_you_mean(name, names);
  throw io::Failure(io::ExitCode::bad_input, "unknown report " + io::quoted(name) +
                                                 (meant.empty() ? "; there are " + listed : meant));
}

/// A word as a shell takes it.
std::string shell_word(const std::string& word) {
  const bool plain = word.find_first_not_of(
                         "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                         "0123456789_-+=.,:/%@") == std::string::npos;
  if (plain && !word.empty()) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

/// The words that ask for the same report.
std::string command_of(const Wishes& wishes) {
  std::string command = "pupflow report " + wishes.kind;
  const auto add = [&](const std::string& option, const std::string& value) {
    command += (option.empty() ? " " : " " + option + " ") + shell_word(value);
  };
  const io::Settings& settings = wishes.common.settings;
  if (!settings.scene.empty()) add("", settings.scene);
  if (!settings.like.empty()) add("--like", settings.like);
  for (const std::string& set : settings.sets) add("--set", set);
  if (settings.seed) add("--seed", *settings.seed);
  if (settings.steps) add("--steps", *settings.steps);
  if (settings.precision) add("--precision", *settings.precision);
  for (const std::string& name : wishes.observables) add("--observable", name);
  if (wishes.seeds > 0) add("--seeds", std::to_string(wishes.seeds));
  return command + (wishes.quick ? " --quick" : "");
}

report::Options options_of(const Wishes& wishes) {
  report::Options options;
  options.folder = wishes.common.out.empty() ? "report-" + wishes.kind : wishes.common.out;
  options.command = command_of(wishes);
  options.threads = thread_count(wishes.common);
  options.quick = wishes.quick;
  options.force = wishes.common.force;
  options.quiet = wishes.common.quiet;
  return options;
}

void work(const Wishes& wishes) {
  const Kind& kind = kind_named(wishes.kind);
  const report::Options options = options_of(wishes);
  const std::string where = "report in " + options.folder + "/report.md\n";
  const bool own = !wishes.common.settings.empty();
  if (!own && (wishes.seeds > 0 || !wishes.observables.empty())) {
    throw io::Failure(
        io::ExitCode::bad_input,
        "--seeds and --observable are about a run of your own; name it, e.g. 'pupflow "
        "report error paper --seeds 10'");
  }
  if (!own) {
    kind.make(options);
    if (!options.quiet) io::print(where);
    return;
  }
  if (kind.make_own == nullptr) {
    throw io::Failure(io::ExitCode::bad_input,
                      "report " + wishes.kind +
                          " has its own scenes; only 'report error' takes a scene or settings");
  }
  const io::Setup setup = io::set_up(wishes.common.settings);
  const report::OwnAnswer answer =
      kind.make_own(options, {setup.params, setup.title, wishes.seeds, wishes.observables});
  if (!options.quiet) io::print(answer.words + where);
  if (!answer.failures.empty()) {
    throw io::Failure(io::ExitCode::bad_numbers, answer.failures);
  }
}

}  // namespace

Verb add_report(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "report",
      "Measure the program, or a run of your own: error against run time, what is stable, and "
      "what the model does");
  const auto wishes = std::make_shared<Wishes>();
  app->add_option("KIND", wishes->kind,
                  "error: error against run time, scene by scene, or of SCENE; stability: maps of "
                  "what is stable, and extreme scenes; validation: what the model does, beside "
                  "what the paper says")
      ->option_text(" ");
  CommonHelp help;
  help.settings = "with 'error' alone";
  help.threads = "Runs at a time where nothing is timed (default: all cores)";
  help.out = "The folder for report.md, figures and CSV files (default report-KIND)";
  help.quiet = "No progress, and no word about what came out";
  add_common(*app, wishes->common, help);
  app->get_option("--out")->option_text("FOLDER");
  app->add_flag("--quick", wishes->quick, "Fewer settings, seeds and shorter runs");
  app->add_option("--observable", wishes->observables,
                  "With 'error SCENE': which mean it is about, a column of a sweep; repeatable "
                  "(default huddling and mean_tb)")
      ->option_text("NAME")
      ->allow_extra_args(false)
      ->take_all();
  app->add_option("--seeds", wishes->seeds,
                  "With 'error SCENE': runs of each setting (default 20, or 5 with --quick)")
      ->option_text("N")
      ->check(CLI::Range(std::int64_t{2}, std::int64_t{1000000}));
  app->footer(
      "'report error SCENE' (or --set, --like) says how exact that run is, and what half or twice "
      "the\n"
      "time would buy: the same seeds with other steps, points, precision, lengths and windows. "
      "Exit\n"
      "code 3 when the scene itself goes bad. Times in a report are those of this machine; close "
      "other\n"
      "work while it is made.");
  return {app, [wishes] { work(*wishes); }};
}

}  // namespace pupflow::cli
