// Runs a sweep into a folder, or goes on with one that was interrupted.
#pragma once

#include <string>
#include <vector>

#include "app/study/results.h"

namespace pupflow::study {

/// Files of a sweep's folder.
std::string runs_path(const std::string& folder);
std::string summary_path(const std::string& folder);
std::string manifest_path(const std::string& folder);
std::string journal_path(const std::string& folder);

struct SweepJob {
  Design design;
  std::string folder;
  int threads = 1;
  bool force = false;  // start afresh where another sweep is
  bool quiet = false;
};

struct SweepResult {
  std::vector<Row> rows;           // of the shard's runs
  std::vector<Summary> summaries;  // empty for one shard of several
  std::int64_t resumed = 0;        // runs that were there already
  std::string note;                // e.g. why there is no plot; may be empty
};

/// Computes what is missing and writes runs.csv, and for a whole sweep summary.csv and the plots.
/// Files do not depend on the number of threads or on interruptions. Throws io::Failure: bad_input
/// when the folder holds another sweep, bad_file, interrupted; finished runs are kept in all cases.
SweepResult run_sweep(const SweepJob& job);

/// Joins the finished shards in `folders` to a whole sweep in `folder`. Throws
/// io::Failure(bad_input) when they do not belong together or one is missing or incomplete.
SweepResult merge_shards(const std::vector<std::string>& folders, const std::string& folder,
                         bool force);

/// The design that a folder's manifest holds. Throws io::Failure.
Design design_of_folder(const std::string& folder);

/// The first run that went wrong, and how many did, in one line; empty when all were fine.
std::string failures_text(const Design& design, const std::vector<Row>& rows);

}  // namespace pupflow::study
