// Many whole runs of the validation report, and means over their seeds.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/report/estimate.h"
#include "app/report/report.h"
#include "pupflow/simulation.h"

namespace pupflow::report {

/// "0.581 ± 0.015": the error in two significant digits, the mean to the same place.
std::string text_of(const MeanAndError& number);

/// Ends a row of a CSV file, and the last one of a table, with these numbers: mean and error in two
/// cells there, as text in one here.
void end_row(const std::vector<MeanAndError>& numbers, io::CsvFile& csv,
             std::vector<io::Row>& rows);

/// One step. Throws io::Failure: interrupted when Ctrl-C came, bad_numbers when the status is bad.
void step_on(Simulation& simulation);

/// The numbers that one run gives; their count is the same for all runs.
using Measure = std::function<std::vector<double>(const Params&)>;

/// Makes a run with each of `settings` and each seed 1 ... `seeds`, on all threads of `options`.
/// Gives the numbers of the run with seed s + 1 as [setting][number][s]. Shows progress as `what`.
/// Throws what `measure` throws, and io::Failure(interrupted).
std::vector<std::vector<std::vector<double>>> all_runs(const std::string& what,
                                                       const std::vector<Params>& settings,
                                                       int seeds, const Options& options,
                                                       const Measure& measure);

/// The same, each number averaged over the seeds: [setting][number].
std::vector<std::vector<MeanAndError>> means_of_runs(const std::string& what,
                                                     const std::vector<Params>& settings, int seeds,
                                                     const Options& options,
                                                     const Measure& measure);

/// `count` evenly spaced numbers from `from` to `to`, both among them.
std::vector<double> spaced(double from, double to, int count);

}  // namespace pupflow::report
