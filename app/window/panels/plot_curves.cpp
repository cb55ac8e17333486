#include "app/window/panels/plot_curves.h"

#include <algorithm>
#include <cmath>

namespace pupflow::window {
namespace {

template <class Point>
std::vector<CurvePoint> curve_of(Entries entries, const Point& point) {
  std::vector<CurvePoint> curve;
  curve.reserve(entries.size());
  for (const History::Entry& entry : entries) curve.push_back(point(entry));
  return curve;
}

}  // namespace

std::vector<CurvePoint> observable_curve(Entries entries, std::size_t observable, double window) {
  const auto member = observables()[observable].value;
  const std::vector<CurvePoint> raw = curve_of(entries, [&](const History::Entry& entry) {
    const History::Sample& sample = *entry.sample;
    return CurvePoint{sample.time, sample.mean.*member, static_cast<double>(sample.low[observable]),
                      static_cast<double>(sample.high[observable])};
  });
  if (window <= 0) return raw;
  std::vector<int> steps;
  for (const History::Entry& entry : entries) steps.push_back(entry.sample->steps);
  return smoothed(raw, steps, window);
}

std::vector<CurvePoint> tb_band(Entries entries) {
  return curve_of(entries, [](const History::Entry& entry) {
    const History::Sample& sample = *entry.sample;
    return CurvePoint{sample.time, sample.mean.mean_tb, sample.coldest, sample.warmest};
  });
}

std::vector<CurvePoint> pup_curve(Entries entries, int pup) {
  std::vector<CurvePoint> curve;
  for (const History::Entry& entry : entries) {
    if (pup < 0 || static_cast<std::size_t>(pup) >= entry.tb.size()) continue;
    const auto tb = static_cast<double>(entry.tb[static_cast<std::size_t>(pup)]);
    curve.push_back({entry.sample->time, tb, tb, tb});
  }
  return curve;
}

std::vector<CurvePoint> temperature_curve(Entries entries, double History::Sample::*temperature) {
  return curve_of(entries, [&](const History::Entry& entry) {
    const double value = entry.sample->*temperature;
    return CurvePoint{entry.sample->time, value, value, value};
  });
}

void widen_to(Range& range, Entries entries, std::size_t observable, Range time, double window) {
  const bool temperature = observables()[observable].observable == Observable::mean_tb;
  for (const CurvePoint& point : observable_curve(entries, observable, window)) {
    if (point.x < time.low || point.x > time.high) continue;
    widen(range, point.low);
    widen(range, point.high);
  }
  if (!temperature) return;
  for (const History::Entry& entry : entries) {
    const History::Sample& sample = *entry.sample;
    if (sample.time < time.low || sample.time > time.high) continue;
    for (const double value : {sample.coldest, sample.warmest, sample.ta, sample.tp}) {
      widen(range, value);
    }
  }
  // A line on the edge would not be seen.
  const double edge = 0.03 * (range.high - range.low);
  range = {range.low - edge, range.high + edge};
}

std::optional<double> value_at(std::span<const CurvePoint> curve, double x) {
  const auto found =
      std::lower_bound(curve.begin(), curve.end(), x,
                       [](const CurvePoint& point, double at) { return point.x < at; });
  if (found == curve.end() || std::isnan(found->mean)) return std::nullopt;
  return found->mean;
}

}  // namespace pupflow::window
