#include "app/report/validation/runs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/io/failure.h"
#include "app/report/share_out.h"

namespace pupflow::report {

std::string text_of(const MeanAndError& number) {
  // Without an error beyond rounding only the mean is shown.
  if (!(number.error > 1e-12 * std::abs(number.mean)) || !std::isfinite(number.error)) {
    return rounded(number.mean);
  }
  const int places = std::clamp(1 - static_cast<int>(std::floor(std::log10(number.error))), 0, 8);
  char text[80];
  std::snprintf(text, sizeof text, "%.*f ± %.*f", places, number.mean, places, number.error);
  return text;
}

void end_row(const std::vector<MeanAndError>& numbers, io::CsvFile& csv,
             std::vector<io::Row>& rows) {
  for (const MeanAndError& number : numbers) {
    csv.cell(number.mean).cell(number.error);
    rows.back().push_back(text_of(number));
  }
  csv.end_row();
}

void step_on(Simulation& simulation) {
  stop_if_interrupted();
  const Status status = simulation.step();
  if (status.ok()) return;
  throw io::Failure(io::ExitCode::bad_numbers, "validation: " + status.message());
}

std::vector<std::vector<std::vector<double>>> all_runs(const std::string& what,
                                                       const std::vector<Params>& settings,
                                                       int seeds, const Options& options,
                                                       const Measure& measure) {
  const auto each = static_cast<std::size_t>(seeds);
  std::vector<std::vector<double>> runs(settings.size() * each);
  share_out(what, static_cast<std::int64_t>(runs.size()), options, [&](std::int64_t run) {
    const auto i = static_cast<std::size_t>(run);
    Params params = settings[i / each];
    params.seed = static_cast<std::int64_t>(i % each) + 1;
    runs[i] = measure(params);
  });
  std::vector<std::vector<std::vector<double>>> numbers(settings.size());
  for (std::size_t i = 0; i < settings.size(); ++i) {
    numbers[i].resize(runs[i * each].size());
    for (std::size_t seed = 0; seed < each; ++seed) {
      const std::vector<double>& run = runs[i * each + seed];
      for (std::size_t number = 0; number < run.size(); ++number) {
        numbers[i][number].push_back(run[number]);
      }
    }
  }
  return numbers;
}

std::vector<std::vector<MeanAndError>> means_of_runs(const std::string& what,
                                                     const std::vector<Params>& settings, int seeds,
                                                     const Options& options,
                                                     const Measure& measure) {
  std::vector<std::vector<MeanAndError>> means;
  for (const auto& numbers : all_runs(what, settings, seeds, options, measure)) {
    means.emplace_back();
    for (const std::vector<double>& values : numbers)
      means.back().push_back(mean_and_error(values));
  }
  return means;
}

std::vector<double> spaced(double from, double to, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(from + (to - from) * i / (count - 1));
  return values;
}

}  // namespace pupflow::report
