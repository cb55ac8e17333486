// pupflow figure2: the paper's Figure 2, by one command.
#include <memory>

#include "app/cli/sweep_work.h"

namespace pupflow::cli {

Verb add_figure2(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "figure2", "Draw the paper's Figure 2: 24 ambient temperatures, 10 seeds each");
  const auto options = std::make_shared<SweepOptions>();
  add_sweep_options(*app, *options, "figure2");
  options->vary = {"ta=0:1:24"};
  return {app,
          [options, app] { run_sweep_verb(*app, *options, "figure2"); },
          {{"figure2 --out figure2", "The figure with its CSV files, in a folder"},
           {"figure2 --seeds 2 --steps 1500 --out quick", "A quick look at it"}}};
}

}  // namespace pupflow::cli
