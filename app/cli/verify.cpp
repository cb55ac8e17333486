// pupflow verify: repeats the runs behind files and compares.
#include "app/verify/verify.h"

#include <memory>

#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"

namespace pupflow::cli {
namespace {

struct VerifyOptions {
  std::vector<std::string> files;
  std::int64_t row = 0;
  int threads = 0;
  bool quiet = false;
};

void work(const VerifyOptions& options) {
  verify::Options how;
  Common common;
  common.threads = options.threads;
  how.threads = thread_count(common);
  how.quiet = options.quiet;
  if (options.row > 0) how.row = options.row;
  std::int64_t differ = 0;
  for (const std::string& file : options.files) {
    const verify::Verdict verdict = verify::verify(file, how);
    const char* word = verdict.same ? ": same (" : ": differs (";
    if (!options.quiet) io::print(file + word + verdict.words + ")\n");
    differ += verdict.same ? 0 : 1;
  }
  if (differ == 0) return;
  throw io::Failure(io::ExitCode::difference, std::to_string(differ) + " of " +
                                                  std::to_string(options.files.size()) +
                                                  " files differ from the runs that made them");
}

}  // namespace

Verb add_verify(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "verify", "Repeat the run behind any output and say whether it is the same");
  const auto options = std::make_shared<VerifyOptions>();
  app->add_option("FILE", options->files,
                  "CSV files of a run, its pups or a sweep's runs, folders of sweeps, recordings, "
                  "checkpoints, "
                  "pictures")
      ->option_text(" ")
      ->required()
      ->check(not_empty);
  app->add_option("--row", options->row, "Of a sweep's runs only this row; 1 is the first")
      ->option_text("N")
      ->check(between(std::int64_t{1}, kUnbounded));
  app->add_option("--threads", options->threads,
                  "Runs at a time, or threads that share a step (default: all cores)")
      ->option_text("N")
      ->check(between(1, 1024));
  app->add_flag("-q,--quiet", options->quiet, "Print nothing; the exit code tells");
  app->footer(
      "Exit code 0 when every file is the same, 1 when one differs: the line says the first "
      "step, pup and field.");
  return {app,
          [options] { work(*options); },
          {{"verify figure1.png", "Whether the picture's run gives the same litter here"},
           {"verify run.h5 cold.csv", "Several files of this program"}}};
}

}  // namespace pupflow::cli
