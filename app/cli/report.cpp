// pupflow report: what the program measures about itself.
#include <algorithm>
#include <memory>
#include <thread>

#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/nearest.h"
#include "app/io/text.h"
#include "app/report/error.h"
#include "app/report/stability.h"

namespace pupflow::cli {
namespace {

/// One kind of report, by the word that asks for it.
struct Kind {
  const char* name;
  void (*make)(const report::Options&);
};

constexpr Kind kKinds[] = {{"error", report::report_error},
                           {"stability", report::report_stability}};

struct Wishes {
  std::string kind, out;
  int threads = 0;
  bool quick = false, force = false, quiet = false;
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

void work(const Wishes& wishes) {
  const Kind& kind = kind_named(wishes.kind);
  report::Options options;
  options.folder = wishes.out.empty() ? "report-" + wishes.kind : wishes.out;
  options.command = "pupflow report " + wishes.kind + (wishes.quick ? " --quick" : "");
  options.threads = wishes.threads > 0
                        ? wishes.threads
                        : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  options.quick = wishes.quick;
  options.force = wishes.force;
  options.quiet = wishes.quiet;
  kind.make(options);
  if (!wishes.quiet) io::print("report in " + options.folder + "/report.md\n");
}

}  // namespace

Verb add_report(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "report", "Measure the program: its error against run time, and where it is stable");
  const auto wishes = std::make_shared<Wishes>();
  app->add_option("KIND", wishes->kind,
                  "error: error against run time, scene by scene; stability: maps of what is "
                  "stable, and extreme scenes")
      ->option_text(" ");
  app->add_flag("--quick", wishes->quick, "Fewer settings and shorter runs");
  app->add_option("--out", wishes->out,
                  "The folder for report.md, figures and CSV files (default report-KIND)")
      ->option_text("FOLDER")
      ->check(not_empty);
  app->add_flag("--force", wishes->force, "Replace a report that is there");
  app->add_option("--threads", wishes->threads,
                  "Runs at a time where nothing is timed (default: all cores)")
      ->option_text("N")
      ->check(CLI::Range(1, 1024));
  app->add_flag("--quiet", wishes->quiet, "No progress, and no word about where the report is");
  app->footer("Times in a report are those of this machine; close other work while it is made.");
  return {app, [wishes] { work(*wishes); }};
}

}  // namespace pupflow::cli
