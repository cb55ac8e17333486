// The section of the error report about what scenes leave out.
#pragma once

#include "app/report/report.h"

namespace pupflow::report {

/// Puts the section on the page, with its CSV file savings.csv: five shipped scenes, what each
/// leaves out, what that saves, and that no bit changes. Throws io::Failure, bad_numbers where a
/// bit does change.
void savings_section(Report& report);

}  // namespace pupflow::report
