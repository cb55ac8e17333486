// A run compared with runs that have other settings, seed by seed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/report/error/changes.h"
#include "app/report/estimate.h"
#include "app/report/report.h"
#include "pupflow/status.h"

namespace pupflow::report {

/// The results of one change.
struct Compared {
  Change change;
  std::string refused;                // why it was not run or has no means; else empty
  std::int64_t bad = 0;               // runs that ended with a bad status
  Status first_bad;                   // of the lowest of their seeds
  std::int64_t warned = 0;            // runs with a warning (pupflow/status.h), good or bad
  std::string first_warning;          // of the lowest of their seeds
  double seconds = 0;                 // processor time of all its runs
  std::vector<Estimate> means;        // over its good runs, by observable
  std::vector<Estimate> differences;  // from the base, over seeds that were good in both

  /// What is wrong with the row, e.g. "3 of 20 runs failed, the first with ..."; empty if nothing
  /// is.
  std::string trouble(std::int64_t seeds) const;
};

/// A base and its changes, over the same seeds.
struct Paired {
  std::vector<std::string> observables;  // names of run statistics
  std::int64_t seeds = 0;
  std::vector<Compared> rows;  // the base first
};

/// What to compare.
struct PairedWork {
  std::string name;             // for the progress
  std::vector<Change> changes;  // the base first
  std::int64_t seeds = 0;       // how many, at least 2; the first is the base's seed
  std::vector<std::string> observables;
};

/// Runs every change with every seed, on `options.threads` threads. Changes of steps and discard
/// alone share their runs. Throws io::Failure (interrupted).
Paired compare(const PairedWork& work, const Options& options);

/// The interval of the base's mean for another number of seeds.
double interval_with(const Paired& paired, std::size_t observable, std::int64_t seeds);

/// "0.571 ± 0.012": the interval has two significant digits, the mean as many decimals; with `sign`
/// a positive mean has a +.
std::string words_of(const Estimate& estimate, bool sign = false);

/// How to read the table and the plot of a comparison, for the page.
std::string how_to_read();

/// Adds a comparison to the page: NAME.csv, a plot NAME with `caption`, and a table.
void show(Report& report, const std::string& name, const std::string& caption,
          const Paired& paired);

}  // namespace pupflow::report
