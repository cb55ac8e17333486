// Means over seeds and how far they may be off.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace pupflow::report {

/// A mean over seeds, and its standard error.
struct MeanAndError {
  double mean = 0, error = 0;
};

/// The mean of `values` (0 for none) and its standard error, sd / sqrt(count), NaN below two.
MeanAndError mean_and_error(std::span<const double> values);

/// A mean over seeds and half of its 95 % interval (Student's t); NaN where there are too few.
struct Estimate {
  double mean, interval;

  /// Whether the interval leaves out 0.
  bool beyond_chance() const;
};

/// Needs a value for the mean and two for the interval.
Estimate estimate_of(const std::vector<double>& values);

/// Half of the 95 % interval of a mean of `runs` runs, in standard errors: the 97.5 % quantile of
/// Student's t with runs - 1 degrees of freedom. NaN below 2 runs.
double interval_factor(std::int64_t runs);

}  // namespace pupflow::report
