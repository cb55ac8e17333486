// Paints marks and their legend into a picture.
#pragma once

#include "app/io/png.h"
#include "app/view/canvas.h"
#include "app/view/marks.h"
#include "app/view/text.h"

namespace pupflow::view {

/// Paints `marks` over the scene in `image`, which shows what `projection` sees.
void paint_marks(io::Image& image, TextPainter& text, const Marks& marks,
                 const Projection& projection);

/// The width of a legend with text of that size, pixels.
double legend_width(TextPainter& text, const std::vector<LegendEntry>& legend, double size);

/// The legend's entries, one below the other from the upper left corner of the place, with text of
/// that size in pixels. On a halo of paper.
void paint_legend(io::Image& image, TextPainter& text, const std::vector<LegendEntry>& legend,
                  double x, double y, double size);

/// Text with a halo of paper, so that it can be read on anything.
void paint_label(io::Image& image, TextPainter& text, double x, double y, const TextLine& line,
                 double size, Rgb color, Align align = Align::left);

}  // namespace pupflow::view
