// pupflow report stability: where the method is stable, and extreme scenes.
#pragma once

#include "app/report/report.h"

namespace pupflow::report {

/// Writes the whole report: classes, maps, extreme scenes. Throws io::Failure.
void report_stability(const Options& options);

}  // namespace pupflow::report
