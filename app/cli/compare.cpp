// pupflow compare: compares the summaries of two sweeps.
#include <memory>

#include "app/cli/summary.h"
#include "app/cli/verb.h"
#include "app/io/atomic_file.h"
#include "app/study/compare.h"

namespace pupflow::cli {

Verb add_compare(CLI::App& program) {
  CLI::App* app = program.add_subcommand("compare", "Compare the summaries of two sweeps");
  struct CompareOptions {
    std::vector<std::string> paths;
    bool json = false;
    bool celsius = false;
  };
  const auto options = std::make_shared<CompareOptions>();
  app->add_option("SWEEP", options->paths,
                  "Two folders of sweeps, or their summary.csv, with the same points")
      ->option_text(" ")
      ->required()
      ->expected(2)
      ->check(not_empty);
  app->footer(
      "Shows the differences of the means in units of their combined standard error\n"
      "sqrt(sd1^2 / runs1 + sd2^2 / runs2).");
  add_json(*app, options->json);
  add_celsius(*app, options->celsius);
  return {app,
          [options, app] {
            refuse_idle(*app, "--celsius", !options->json,
                        "a table for people; JSON has the model's units");
            const study::Comparison comparison =
                study::compare_summaries(options->paths[0], options->paths[1]);
            io::print(options->json ? comparison_json(comparison)
                                    : comparison_text(comparison, options->celsius));
          },
          {{"compare sweep-a sweep-b",
            "Two sweeps over the same points, e.g. before and after a change"},
           {"compare old/summary.csv new/summary.csv --json",
            "The same from two files, for a program"}}};
}

}  // namespace pupflow::cli
