#include "app/report/validation/validation.h"

#include "app/report/validation/sections.h"

namespace pupflow::report {

void report_validation(const Options& options) {
  Report report(options, "Validation");
  report.text(
      "Every number on this page is a mean over litters that differ in their seeds, with its "
      "standard error after ±. Parameters are the defaults unless a section says otherwise; time "
      "is in model seconds, a step is 0.01 of one. A is the share of a pup's points that touch no "
      "other pup.");
  for (const auto& section :
       {readings_section, window_section, wall_section, flow_section, overlap_section,
        units_section, heat_section, symmetry_section, body_section}) {
    section(report);
  }
  report.finish();
}

}  // namespace pupflow::report
