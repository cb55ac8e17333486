// pupflow compare: compares the summaries of two sweeps.
#include <memory>

#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/study/compare.h"

namespace pupflow::cli {

Verb add_compare(CLI::App& program) {
  CLI::App* app = program.add_subcommand("compare", "Compare the summaries of two sweeps");
  const auto paths = std::make_shared<std::vector<std::string>>();
  app->add_option("SWEEP", *paths,
                  "Two folders of sweeps, or their summary.csv, with the same points")
      ->option_text(" ")
      ->required()
      ->expected(2)
      ->check(not_empty);
  app->footer(
      "Shows the differences of the means in units of their combined standard error\n"
      "sqrt(sd1^2 / runs1 + sd2^2 / runs2).");
  return {app, [paths] {
            io::print(study::comparison_text(study::compare_summaries((*paths)[0], (*paths)[1])));
          }};
}

}  // namespace pupflow::cli
