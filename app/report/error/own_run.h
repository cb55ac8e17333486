// pupflow report error SCENE: how exact a run of the user's own is, and what more time would buy.
#pragma once

#include "app/report/report.h"

namespace pupflow::report {

/// The run in question.
struct OwnRun {
  Params params;  // its seed is the first of all
  std::string title;
  std::int64_t seeds = 0;                // 0: twenty, or five of a quick report
  std::vector<std::string> observables;  // empty: huddling and mean_tb
};

/// The answer in short.
struct OwnAnswer {
  std::string words;     // a line for each observable
  std::string failures;  // what went bad in the run as it is; empty for nothing
};

/// Writes the report. Throws io::Failure: bad_input when the run has no means or an observable is
/// unknown.
OwnAnswer report_own_error(const Options& options, const OwnRun& run);

}  // namespace pupflow::report
