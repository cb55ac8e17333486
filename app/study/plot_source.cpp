#include "app/study/plot_source.h"

#include <algorithm>
#include <map>

namespace pupflow::study {

std::vector<const Axis*> plotted_axes(const Design& design) {
  std::vector<const Axis*> axes;
  for (const Axis& axis : design.axes) {
    if (drawn_values(axis).size() > 1) axes.push_back(&axis);
  }
  return axes;
}

std::vector<double> drawn_values(const Axis& axis) {
  std::vector<double> values;
  if (axis.parameter->kind == Parameter::Kind::choice) {
    for (const double value : axis.values) {
      if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
    }
    return values;
  }
  values = axis.values;
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

PlotSource plot_source(const Design& design, const std::vector<Summary>& summaries,
                       const std::vector<const Axis*>& axes) {
  std::vector<std::map<double, std::size_t>> places;  // of each axis: the place of each value
  for (const Axis* axis : axes) {
    places.emplace_back();
    for (const double value : drawn_values(*axis))
      places.back().emplace(value, places.back().size());
  }
  const auto key_of = [&](const Summary& summary) {
    std::vector<std::size_t> key;
    for (std::size_t i = 0; i < axes.size(); ++i)
      key.push_back(
          places[i].at(summary.values[static_cast<std::size_t>(axes[i] - design.axes.data())]));
    return key;
  };
  std::vector<std::pair<std::vector<std::size_t>, const Summary*>> points;
  points.reserve(summaries.size());
  for (const Summary& summary : summaries) points.emplace_back(key_of(summary), &summary);
  const auto before = [](const auto& a, const auto& b) { return a.first < b.first; };
  if (std::is_sorted(points.begin(), points.end(), before)) return {"'summary.csv'", ""};
  std::stable_sort(points.begin(), points.end(), before);
  std::string block = "# The rows of summary.csv in rising order.\n$summary << END\n" +
                      summary_columns(design) + "\n";
  for (const auto& [place, summary] : points) block += summary_text(design, *summary) + "\n";
  return {"$summary", block + "END\n"};
}

}  // namespace pupflow::study
