// Rows of a sweep: one per run, and one per point with means over its seeds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/study/design.h"
#include "pupflow/ensemble.h"

namespace pupflow::study {

/// One finished run.
struct Row {
  std::int64_t run = 0;         // its index in the design
  std::string status = "fine";  // or the bad status; then warnings; all without commas
  Observables means;
  double exposed_sd = 0;

  bool fine() const { return status == "fine" || warned(); }
  bool warned() const { return status.starts_with("fine; "); }
};

Row make_row(std::int64_t run, const RunResult& result);

/// Number `i` of run_statistics() in a row.
double& statistic(Row& row, std::size_t i);
double statistic(const Row& row, std::size_t i);

/// Column names and one line (without its end) of the runs CSV.
std::string runs_columns(const Design& design);
std::string row_text(const Design& design, const Row& row);

/// How many bytes a file with a row per run may have, its manifest included.
std::size_t largest_file(const Design& design);

/// Reads such a line of run number `run`. Nothing when the line is damaged or belongs to another
/// run.
std::optional<Row> parse_row(const Design& design, std::int64_t run, const std::string& line);

/// Mean and sample standard deviation over the seeds.
struct Spread {
  double mean, sd;
};

/// One point. Bad runs are counted and left out of everything else; those with a warning are
/// counted and left in.
struct Summary {
  std::vector<double> values;  // of the varied parameters
  std::int64_t runs = 0, failed = 0, warned = 0;
  std::vector<Spread> statistics;  // of run_statistics()
  double susceptibility = 0;  // |d<A>/dT_a| by central differences between the neighbouring T_a at
                              // which all else is equal; NaN where there are none
};

/// Summaries of all points in their order; `rows` holds every run of the design, in order. Rows of a
/// table with given seeds are one point where all varied parameters are equal.
std::vector<Summary> summarise(const Design& design, const std::vector<Row>& rows);

/// "10 seeds", "3 to 5 seeds": how many runs the points have.
std::string seeds_text(const std::vector<Summary>& summaries);

/// Column names and one line (without its end) of the summary CSV.
std::string summary_columns(const Design& design);
std::string summary_text(const Design& design, const Summary& summary);

/// Writes NAME.csv style files into place, replacing what is there. Throw io::Failure(bad_file).
void write_runs(const std::string& path, const Design& design, const std::vector<Row>& rows);
void write_summary(const std::string& path, const Design& design,
                   const std::vector<Summary>& summaries);

/// Reads back all own runs of a design. Throws io::Failure: bad_file when the file cannot be read,
/// bad_input when it is not complete or not of this design.
std::vector<Row> read_runs(const std::string& path, const Design& design);

}  // namespace pupflow::study
