#include "app/report/validation/validation.h"

#include "app/report/validation/sections.h"

namespace pupflow::report {

void report_validation(const Options& options) {
  Report report(options, "Validation");
  report.text(
      "Every number on this page is a mean over litters with different seeds, with its standard "
      "error after ±. Parameters are the defaults unless a section states others. Time is in model "
      "seconds; a step is 0.01 s. A is the share of a pup's points that touch no other pup.");
  for (const auto section : kValidationSections) section(report);
  report.finish();
}

}  // namespace pupflow::report
