// pupflow merge: joins the shards of a sweep.
#include <memory>

#include "app/cli/summary.h"
#include "app/cli/sweep_work.h"
#include "app/study/folder.h"
#include "app/study/merge.h"

namespace pupflow::cli {
namespace {

struct MergeOptions {
  std::vector<std::string> folders;
  std::string out, plot_script;
  bool force = false, quiet = false, celsius = false;
};

void merge(const MergeOptions& options) {
  check_plot_script(options.plot_script);
  const study::SweepResult result =
      study::merge_shards(options.folders, options.out, options.force, options.plot_script);
  report_sweep(study::design_of_folder(options.out), result, options.out,
               {options.quiet, options.celsius});
}

}  // namespace

Verb add_merge(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("merge", "Join the shards of a sweep; refuses an incomplete set");
  const auto options = std::make_shared<MergeOptions>();
  app->add_option("FOLDER", options->folders, "The shards' folders")
      ->option_text(" ")
      ->required()
      ->check(not_empty);
  app->add_option("-o,--out", options->out, "The folder for the whole")
      ->option_text("FOLDER")
      ->required()
      ->check(not_empty);
  add_plot_script(*app, options->plot_script);
  add_celsius(*app, options->celsius);
  app->add_flag("--force", options->force, "Replace another sweep there");
  app->add_flag("-q,--quiet", options->quiet, "No summary at the end");
  return {app,
          [options, app] {
            refuse_idle(*app, "--celsius", !options->quiet,
                        "the summary, which --quiet leaves out");
            merge(*options);
          },
          {{"merge shard-1 shard-2 --out whole", "Two shards of one sweep, joined"},
           {"merge shards/* --out whole --force",
            "All shards of a folder, in place of an earlier result"}}};
}

}  // namespace pupflow::cli
