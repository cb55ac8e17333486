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
  std::vector<std::string> observables;       // that were compared, and
  std::vector<std::string> left_out;          // those that one of the files lacks
  std::vector<Difference> differences;
  int beyond_three = 0;   // points more than three standard errors apart
  int unknown = 0;        // points where a file has fewer than two runs, so no standard error
  double rms = 0;         // root mean square of all other standard_errors
  double largest_tb = 0;  // largest difference of mean_tb
  double largest_tb_errors = 0;  // the same in standard errors, where these are known
};

/// Compares all observables that both files hold. Varied parameters must be the same and
/// agree within 1e-5 relative. Throws io::Failure: bad_file when a file cannot be
/// read, bad_input when it is no summary or they do not fit together.
Comparison compare_summaries(const std::string& first, const std::string& second);

/// A table of all points, and the totals below it.
std::string comparison_text(const Comparison& comparison);

}  // namespace pupflow::study
