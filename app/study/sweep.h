// Runs a sweep into a folder, or resumes one that was interrupted.
#pragma once

#include <string>
#include <vector>

#include "app/study/executor.h"
#include "app/study/results.h"

namespace pupflow::study {

struct SweepJob {
  Design design;
  std::string folder;
  int threads = 1;
  Executor* executor = nullptr;  // computes the runs instead of the threads of this process
  bool force = false;            // replace another sweep in the folder
  std::string plot_script = {};  // draws the figure in place of the one in the folder; draw_plots
  bool quiet = false;
};

struct SweepResult {
  std::vector<Row> rows;           // of the shard's runs
  std::vector<Summary> summaries;  // empty for one shard of several
  std::int64_t resumed = 0;        // runs that were there already
  std::string note;                // e.g. why there is no plot; may be empty
};

/// Computes the missing runs and writes runs.csv, and for a whole sweep summary.csv and the plots.
/// Files do not depend on the number of threads or on interruptions. Throws io::Failure: bad_input
/// when the folder holds another sweep, bad_file, also when another process is at work there,
/// interrupted; finished runs are kept in all cases.
SweepResult run_sweep(const SweepJob& job);

/// Writes the result files for the rows of a shard or of a whole sweep. Throws
/// io::Failure: bad_file, or interrupted while drawing.
SweepResult write_results(const std::string& folder, const Design& design, std::vector<Row> rows,
                          const std::string& plot_script = {});

/// One line: how many runs failed, and the first of them; empty when all were fine.
std::string failures_text(const Design& design, const std::vector<Row>& rows);

/// The same of the runs that ended with a warning.
std::string warnings_text(const Design& design, const std::vector<Row>& rows);

}  // namespace pupflow::study
