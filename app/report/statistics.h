// The statistics of a run (run_statistics, pupflow/observer.h), for tables and CSV files.
#pragma once

#include <string>
#include <vector>

#include "app/io/table.h"
#include "pupflow/observer.h"

namespace pupflow::report {

/// All statistics of a run, in the order of run_statistics().
std::vector<double> statistics_of(const RunMeans& means);

/// Their names, in the same order, and that of the mean of one observable.
std::vector<std::string> statistic_names();
std::string statistic_name(Observable observable);

/// ",NAME,NAME_se" for each, to end the columns of a CSV file.
std::string statistic_columns();

/// Adds the label of each to the first row of a table.
void add_statistic_labels(io::Row& head);

}  // namespace pupflow::report
