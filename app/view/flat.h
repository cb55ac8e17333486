// Marks as they lie in a picture: lines, filled polygons and text in pixels from its upper left
// corner. Made once for both painters, that of pictures and that of the window.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <variant>
#include <vector>

#include "app/view/marks.h"
#include "app/view/text.h"

namespace pupflow::view {

struct FlatLine {  // with round ends; a dot where both ends are one
  Eigen::Vector2d from, to;
  double width;
  Ink ink;
};
struct FlatFill {
  std::vector<Eigen::Vector2d> corners;
  Ink ink;
};
struct FlatText {
  Eigen::Vector2d at;  // of its baseline
  TextLine text;
  double size;  // em
  Rgb color;
  Align align = Align::left;
  bool halo = true;  // of paper, so that it can be read on anything
};
using Flat = std::variant<FlatLine, FlatFill, FlatText>;

/// Rows of the picture that the widths and sizes of marks are meant for.
constexpr double kMarkRows = 960;

/// How far from the text the eight copies of it in paper are that make its halo.
inline double halo_width(double text_size) {
  return std::max(1.0, 0.09 * text_size);
}

/// Adds `marks` in their order, as `projection` sees them, widths and sizes times `scale`.
void flatten(const Marks& marks, const Projection& projection, double scale,
             std::vector<Flat>& flats);

/// The width in pixels of a line of text of that size.
using TextWidth = std::function<double(const TextLine& line, double size)>;

/// The width of a legend with text of that size, pixels.
double legend_width(const TextWidth& width_of, const std::vector<LegendEntry>& legend, double size);

/// Adds the legend's entries, one below the other from the upper left corner (x, y), with text of
/// that size.
void flatten_legend(const std::vector<LegendEntry>& legend, double x, double y, double size,
                    std::vector<Flat>& flats);

}  // namespace pupflow::view
