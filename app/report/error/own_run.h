// pupflow report error SCENE: the error of a run of the user's own, and how it depends on run time.
#pragma once

#include "app/report/report.h"

namespace pupflow::report {

/// The run in question.
struct OwnRun {
  Params params;  // its seed is the first of all
  std::string title;
  std::int64_t seeds = 0;                // 0: twenty, or five in a quick report
  std::vector<std::string> observables;  // empty: huddling and mean_tb
};

/// The summary.
struct OwnAnswer {
  std::string words;     // a line for each observable
  std::string failures;  // bad statuses of the run without changes; empty where there are none
};

/// Writes the report. Throws io::Failure(bad_input) when the run has no means or an observable is
/// unknown.
OwnAnswer report_own_error(const Options& options, const OwnRun& run);

}  // namespace pupflow::report
