// pupflow sweep: any parameters over a range, with many seeds.
#include <memory>

#include "app/cli/sweep_work.h"

namespace pupflow::cli {

Verb add_sweep(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("sweep", "Run any parameters over a range, with many seeds");
  const auto options = std::make_shared<SweepOptions>();
  add_sweep_options(*app, *options, "sweep");
  app->add_option(
         "--vary", options->vary,
         "Vary a parameter: name=from:to:count or name=a,b,c; repeat it for a grid. One gives\n"
         "four panels, two give maps, more give the CSV files only")
      ->option_text("RANGE")
      ->allow_extra_args(false)
      ->take_all()
      ->required();
  return {app, [options] { run_sweep_verb(*options, "sweep"); }};
}

}  // namespace pupflow::cli
