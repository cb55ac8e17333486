#include "app/report/statistics.h"

#include "app/study/results.h"

namespace pupflow::report {

std::vector<double> statistics_of(const RunMeans& means) {
  study::Row row;
  row.means = means.means();
  row.exposed_sd = means.exposed_sd();
  std::vector<double> statistics;
  for (std::size_t i = 0; i < kRunStatisticCount; ++i) {
    statistics.push_back(study::statistic(row, i));
  }
  return statistics;
}

std::vector<std::string> statistic_names() {
  std::vector<std::string> names;
  for (const Field& field : run_statistics()) names.emplace_back(field.name);
  return names;
}

std::string statistic_name(Observable observable) {
  return std::string(run_statistics()[statistic_of(observable)].name);
}

std::string statistic_columns() {
  std::string columns;
  for (const std::string& name : statistic_names()) columns += "," + name + "," + name + "_se";
  return columns;
}

void add_statistic_labels(io::Row& head) {
  for (const Field& field : run_statistics()) {
    const std::string unit(field.unit);
    head.push_back(std::string(field.label) + (unit.empty() ? "" : " (" + unit + ")"));
  }
}

}  // namespace pupflow::report
