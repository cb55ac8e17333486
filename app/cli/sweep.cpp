// pupflow sweep: any parameters over ranges or from a table, with many seeds.
#include <memory>

#include "app/cli/sweep_work.h"
#include "app/cli/verb.h"

namespace pupflow::cli {

Verb add_sweep(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "sweep", "Run any parameters over ranges or from a table, with many seeds");
  const auto options = std::make_shared<SweepOptions>();
  add_sweep_options(*app, *options, "sweep");
  app->add_option("--vary", options->vary,
                  "Vary a parameter: name=from:to:count, name=from:to:step=S or name=a,b,c; repeat "
                  "it for a grid. One gives four panels, two give maps, more give the CSV files "
                  "only")
      ->option_text("RANGE")
      ->allow_extra_args(false)
      ->take_all();
  app->add_option("--lhs", options->lhs,
                  "N points of a latin hypercube in place of a grid; ranges are name=from:to or "
                  "name=a,b,c")
      ->option_text("N")
      ->check(between(std::int64_t{1}, study::kMostValues));
  app->add_option(
         "--design", options->design,
         "The points are the rows of a CSV file whose header names parameters, in place of "
         "--vary; a column seed gives the seed of each row ('-' is standard input)")
      ->option_text("FILE")
      ->check(not_empty);
  return {app,
          [options, app] { run_sweep_verb(*app, *options, "sweep"); },
          {{"sweep --vary ta=0:1:24 --seeds 10 --out heat", "One parameter over its range"},
           {"sweep cold --vary alpha=0.2,0.7 --vary beta=0,0.5 --out shapes",
            "A grid of two parameters"}}};
}

}  // namespace pupflow::cli
