// pupflow report error: the error of each method and setting against its run time.
#pragma once

#include "app/report/report.h"

namespace pupflow::report {

/// Writes the whole report. Throws io::Failure.
void report_error(const Options& options);

}  // namespace pupflow::report
