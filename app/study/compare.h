// Compares two summaries of the same sweep.
#pragma once

#include <string>
#include <vector>

namespace pupflow::study {

/// How one observable at one grid point differs between two summaries.
struct Difference {
  std::size_t row;  // grid point, from 0
  std::string observable;
  double first, second;    // the means
  double standard_errors;  // (first - second) over the combined standard error of both means;
                           // NaN where that is unknown
};

struct Comparison {
  std::vector<std::string> varied;            // names of the columns before `runs`
  std::vector<std::vector<std::string>> key;  // their values at each grid point
  std::vector<std::string> observables;       // compared
  std::vector<std::string> left_out;          // not compared, since one of the files lacks them
  std::vector<Difference> differences;
  int beyond_three = 0;   // points more than three standard errors apart
  int unknown = 0;        // points where a file has fewer than two runs, so no standard error
  double rms = 0;         // root mean square of all other standard_errors
  double largest_tb = 0;  // largest difference of mean_tb
  double largest_tb_errors = 0;  // the same in standard errors, where these are known
};

/// Compares all observables that both files hold. Each is a summary CSV, or the folder of a sweep,
/// whose summary.csv it is. Both must vary the same parameters, with values
/// that agree to a relative 1e-5. Throws io::Failure: bad_file when a file cannot be read, bad_input
/// when it is no summary or the two do not have the same points.
Comparison compare_summaries(const std::string& first, const std::string& second);

/// All of it as one JSON object.
std::string comparison_json(const Comparison& comparison);

/// A table of all points, followed by the totals; with `celsius` also in degrees where they are
/// temperatures.
std::string comparison_text(const Comparison& comparison, bool celsius = false);

}  // namespace pupflow::study
