// The statistics of a run over T_a, for each reading of the contact rule.
#pragma once

#include "app/report/validation/runs.h"
#include "pupflow/observer.h"

namespace pupflow::report {

/// A reading of the contact rule, and its name as a parameter value.
struct Reading {
  const char* name;
  ContactRule rule;
};
constexpr Reading kReadings[] = {
    {"nearest", ContactRule::nearest}, {"mean", ContactRule::mean}, {"sum", ContactRule::sum}};

/// The statistics (run_statistics) of one run over its steps after `discard`.
std::vector<double> measure_reading(const Params& params);

/// One reading over T_a.
struct ReadingCurve {
  std::string reading;
  std::vector<double> ta;
  std::vector<std::vector<MeanAndError>> means;  // [temperature][run statistic]
  std::vector<double> slope;                     // |dA/dT_a| by central differences
  std::vector<double> held;                      // T_a* = T_p - G/(k1 A)
};

/// The highest mean of a statistic for T_a from 0.3 to 0.6, where the paper has the transition.
struct Peak {
  double ta, height;
  double above;  // above the means at lower T_a and above those at higher T_a, in standard errors
                 // of the difference: the largest value on each side, then the smaller of the two;
                 // 0 at an end of the range
};
Peak peak_of(const ReadingCurve& curve, std::size_t statistic);

}  // namespace pupflow::report
