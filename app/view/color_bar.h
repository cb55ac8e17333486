// The legend that tells which color means which value: a bar with ticks, or a swatch for each
// category. One layout, which the pictures and the window each paint.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "app/view/canvas.h"
#include "app/view/color_scale.h"
#include "app/view/text.h"

namespace pupflow::view {

/// `value` as short text for a label ("0.2", "-1").
std::string tick_label(double value);

/// What a field is called on axes and legends: label, symbol, unit.
TextLine title_of(const Field& field);

struct ColorBarStyle {
  double text_size = 16;  // em of the tick labels, pixels
  Rgb ink{40, 40, 40};
  bool titled = true;    // says what field it is of
  bool celsius = false;  // a temperature's bar has degrees on its left, too
};

/// Pixels that labels and title need on either side of a bar. They do not depend on the data, so
/// that pictures of one run are laid out alike.
struct ColorBarMargins {
  int left = 0, right = 0;
};
ColorBarMargins color_bar_margins(const ColorScale& scale, const ColorBarStyle& style);

/// Pixels from top to bottom of the smallest picture whose legend shows all its words, if the bar
/// takes three quarters of them. It does not depend on the data either.
double color_bar_room(const ColorScale& scale, const ColorBarStyle& style, TextPainter& text);

/// What a legend consists of, in pixels from the upper left corner, y downwards. All but the fills
/// is drawn in ink, in this order.
struct ColorBar {
  struct Fill {
    Box box;
    Rgb color;
  };
  struct Stroke {
    double x0, y0, x1, y1, width;
  };
  struct Triangle {
    Eigen::Vector2d corners[3];
    std::optional<Rgb> color;  // none: ink
  };
  struct Wheel {  // colors around a centre, counter-clockwise from the right
    Eigen::Vector2d centre;
    double inner, outer;
    Colormap map;  // from -pi to pi
  };
  struct Label {
    double x, y;  // of its baseline; where it reads upwards its middle
    TextLine text;
    double size;
    Align align = Align::left;
    bool upwards = false;
  };
  std::vector<Fill> fills;
  std::vector<Box> frames;  // one pixel wide, just inside the box
  std::vector<Stroke> strokes;
  std::vector<Triangle> triangles;
  std::optional<Wheel> wheel;
  std::vector<Label> labels;
};

/// The legend of a fitted scale in `bar`: ticks and labels to its right, the title along it, or
/// over the swatches. Triangles at its ends say that there are values beyond. An angle has a wheel
/// instead. Where the field is a temperature, the preferred temperature `tp` is marked; beyond the
/// scale by a triangle that points there. Values that are not known have a swatch below. `margins`
/// are those of the scale before it was fitted. Degrees stand on the left, where T_p leaves them room.
ColorBar lay_out_color_bar(const Box& bar, const ColorBarMargins& margins, const ColorScale& scale,
                           double tp, const ColorBarStyle& style);

/// The color of an angle in -pi ... pi.
Rgb wheel_color(const ColorBar::Wheel& wheel, double angle);

/// Paints it into a picture.
void draw_color_bar(io::Image& image, TextPainter& text, const ColorBar& layout, Rgb ink);

}  // namespace pupflow::view
