#include "app/report/error.h"

namespace pupflow::report {

void report_error(const Options& options) {
  Report report(options, "Error against run time");
  report.finish();
}

}  // namespace pupflow::report
