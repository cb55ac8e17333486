// pupflow compare: two sweeps' summaries against each other.
#include <memory>

#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/study/compare.h"

namespace pupflow::cli {

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
