#include "app/window/panels/plot_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/io/text.h"
#include "app/view/color_scale.h"

namespace pupflow::window {
namespace {

/// A range that can be divided by.
Range sound(Range range) {
  if (!(range.low <= range.high)) return {0, 1};
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  const double least = std::max(1e-6 * size, 1e-9);
  if (range.high - range.low >= least) return range;
  const double middle = (range.low + range.high) / 2;
  return {middle - least, middle + least};
}

}  // namespace

void widen(Range& range, double value) {
  if (!std::isfinite(value)) return;
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
}

float Axis::place(double value) const {
  constexpr double kFar = 1000;  // beyond any window, and still a number
  const double share = std::clamp((value - values.low) / (values.high - values.low), -kFar, kFar);
  return from + static_cast<float>(share * static_cast<double>(to - from));
}

double Axis::value(float place) const {
  const double share = static_cast<double>((place - from) / (to - from));
  return values.low + share * (values.high - values.low);
}

std::vector<Tick> ticks(Range range, int count, double least) {
  range = sound(range);
  const double spacing = view::tick_spacing(range.low, range.high, count, least);
  const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(spacing) + 1e-9)), 0, 9);
  std::vector<Tick> found;
  for (const double value : view::round_ticks(range.low, range.high, count, least)) {
    const double shown = std::abs(value) < spacing / 2 ? 0 : value;  // no "-0"
    const bool large = std::abs(value) >= 1e6;
    found.push_back(
        {shown, large ? io::formatted("%.3g", shown) : io::formatted("%.*f", decimals, shown)});
  }
  return found;
}

Range rounded(Range range, int count, double least) {
  range = sound(range);
  const double spacing = view::tick_spacing(range.low, range.high, count, least);
  return {spacing * std::floor(range.low / spacing + 1e-6),
          spacing * std::ceil(range.high / spacing - 1e-6)};
}

std::vector<Column> columns(std::span<const CurvePoint> curve, const Axis& x) {
  std::vector<Column> found;
  long column = 0;
  for (const CurvePoint& point : curve) {
    if (std::isnan(point.mean)) continue;
    const float place = x.place(point.x);
    const long here = std::lround(place);
    if (found.empty() || here != column) {
      column = here;
      found.push_back({place, point.mean, point.mean, point.low, point.high});
      continue;
    }
    Column& last = found.back();
    last.last = point.mean;
    last.low = std::min(last.low, point.low);
    last.high = std::max(last.high, point.high);
  }
  return found;
}

std::vector<CurvePoint> smoothed(std::span<const CurvePoint> curve, std::span<const int> weights,
                                 double window) {
  std::vector<CurvePoint> found;
  double sum = 0, weight = 0;
  std::size_t oldest = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!std::isnan(curve[i].mean)) {
      sum += weights[i] * curve[i].mean;
      weight += weights[i];
    }
    for (; oldest < i && curve[oldest].x <= curve[i].x - window; ++oldest) {
      if (std::isnan(curve[oldest].mean)) continue;
      sum -= weights[oldest] * curve[oldest].mean;
      weight -= weights[oldest];
    }
    const double mean = weight > 0 ? sum / weight : std::numeric_limits<double>::quiet_NaN();
    found.push_back({curve[i].x, mean, mean, mean});
  }
  return found;
}

Histogram histogram(std::span<const double> values, Range range, int bins) {
  Histogram found{range, std::vector<int>(static_cast<std::size_t>(bins))};
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    const double share = (value - range.low) / (range.high - range.low);
    const double bin = std::clamp(std::floor(share * bins), 0.0, bins - 1.0);
    ++found.counts[static_cast<std::size_t>(bin)];
  }
  return found;
}

}  // namespace pupflow::window
