#include "app/report/estimate.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace pupflow::report {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Probability that |t| of `df` degrees of freedom stays below `t`: Abramowitz & Stegun 26.7.3 and
/// 26.7.4.
double share_within(double t, std::int64_t df) {
  const double theta = std::atan(t / std::sqrt(static_cast<double>(df)));
  const double cosine = std::cos(theta), square = cosine * cosine;
  const bool odd = df % 2 == 1;
  double term = odd ? cosine : 1, sum = df == 1 ? 0 : term;
  for (std::int64_t j = odd ? 3 : 2; j <= df - 2; j += 2) {
    term *= square * static_cast<double>(j - 1) / static_cast<double>(j);
    sum += term;
  }
  return odd ? 2 / std::numbers::pi * (theta + std::sin(theta) * sum) : std::sin(theta) * sum;
}

}  // namespace

bool Estimate::beyond_chance() const {
  return std::abs(mean) > interval;
}

MeanAndError mean_and_error(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  double mean = 0, squares = 0;
  for (const double value : values) mean += value / n;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, values.size() < 2 ? kNone : std::sqrt(squares / (n - 1) / n)};
}

Estimate estimate_of(const std::vector<double>& values) {
  if (values.empty()) return {kNone, kNone};
  const auto [mean, error] = mean_and_error(values);
  return {mean, interval_factor(static_cast<std::int64_t>(values.size())) * error};
}

double interval_factor(std::int64_t runs) {
  if (runs < 2) return kNone;
  double low = 1.9, high = 13;  // of a normal distribution, 1.96; of one degree of freedom, 12.7
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (share_within(middle, runs - 1) < 0.95 ? low : high) = middle;
  }
  return high;
}

}  // namespace pupflow::report
