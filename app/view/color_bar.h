// The bar that tells which colour means which body temperature.
#pragma once

#include <string>
#include <vector>

#include "app/view/canvas.h"
#include "app/view/colormap.h"
#include "app/view/text.h"

namespace pupflow::view {

/// Round values within [low, high], about `count` of them, evenly spaced by 1, 2 or 5 times a power
/// of ten.
std::vector<double> round_ticks(double low, double high, int count);

/// `value` as short text for a label ("0.2", "-1").
std::string tick_label(double value);

struct ColorBarStyle {
  double text_size = 16;  // em of the tick labels, pixels
  Rgb ink{40, 40, 40};
};

/// Pixels that labels need on either side of a bar.
struct ColorBarMargins {
  int left = 0, right = 0;
};
ColorBarMargins color_bar_margins(const ColorBarStyle& style);

/// Draws an upright bar filling `bar`, ticks and labels to its right, the preferred temperature
/// `tp` marked with an arrow and T_p when it lies on the scale, and along it "body temperature
/// T_b".
void draw_color_bar(io::Image& image, TextPainter& text, const Box& bar, const ColorScale& scale,
                    double tp, const ColorBarStyle& style);

}  // namespace pupflow::view
