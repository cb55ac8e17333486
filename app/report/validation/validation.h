// pupflow report validation: measurements of the model, to compare with the paper.
#pragma once

#include "app/report/report.h"

namespace pupflow::report {

/// Makes the whole report. Throws io::Failure(bad_file), (bad_numbers), (interrupted).
void report_validation(const Options& options);

}  // namespace pupflow::report
