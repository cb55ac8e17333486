// Where values stand in a plot. Knows no Dear ImGui.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace pupflow::window {

struct Range {
  double low, high;
};

/// Widens `range` to `value`; NaN changes nothing.
void widen(Range& range, double value);

/// From values to places along one edge of a plot, in window coordinates.
struct Axis {
  Range values;
  float from, to;  // places of the low and the high end

  float place(double value) const;
  double value(float place) const;
};

struct Tick {
  double value;
  std::string text;
};

/// Ticks at round numbers, about `count` of them, not closer than `least`. All have the same number
/// of decimals.
std::vector<Tick> ticks(Range range, int count, double least = 0);

/// The most ticks along `axis` whose texts do not touch, at most `most`: `extent(text)` is how much
/// room a text takes along the axis, `gap` the least between two. Fewer than two where no more fit.
template <class Extent>
std::vector<Tick> ticks_that_fit(const Axis& axis, int most, float gap, const Extent& extent,
                                 double least = 0) {
  std::vector<Tick> found;
  for (int count = most; count > 0; --count) {
    found = ticks(axis.values, count, least);
    bool fit = true;
    for (std::size_t i = 1; i < found.size() && fit; ++i) {
      const float middles = axis.place(found[i].value) - axis.place(found[i - 1].value);
      const float room = (extent(found[i].text) + extent(found[i - 1].text)) / 2 + gap;
      fit = (middles < 0 ? -middles : middles) >= room;
    }
    if (fit) return found;
  }
  return {};
}

/// `range` with its ends moved outwards to the ticks of `count`; never empty.
Range rounded(Range range, int count, double least = 0);

/// A point of a curve, which may stand for several: their mean and extremes.
struct CurvePoint {
  double x, mean, low, high;
};

/// What a curve does in one column of pixels.
struct Column {
  float x;             // a place
  double first, last;  // means
  double low, high;    // extremes
};

/// The points of a curve, in the order of their x, joined column by column, so that no extreme is
/// lost however many they are. Points that are not known (NaN) are left out.
std::vector<Column> columns(std::span<const CurvePoint> curve, const Axis& x);

/// The mean of the last `window` of x up to each point. `weights` are those of the points.
std::vector<CurvePoint> smoothed(std::span<const CurvePoint> curve, std::span<const int> weights,
                                 double window);

/// Numbers of values in bins of equal width. Values that are not finite are left out; those beyond
/// the ends fall into the bins there.
struct Histogram {
  Range range;
  std::vector<int> counts;
};
Histogram histogram(std::span<const double> values, Range range, int bins);

}  // namespace pupflow::window
