// pupflow report error: how exact each way of computing is, against the time it takes.
#pragma once

#include "app/report/report.h"

namespace pupflow::report {

/// Writes the whole report. Throws io::Failure.
void report_error(const Options& options);

}  // namespace pupflow::report
