// Lines of text with italics and subscripts, drawn into pictures.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/io/png.h"
#include "app/view/colormap.h"

namespace pupflow::view {

/// A stretch of a line in one style. Text is UTF-8.
struct TextRun {
  enum class Style { upright, italic, subscript };
  std::string text;
  Style style = Style::upright;
};
using TextLine = std::vector<TextRun>;

/// An italic symbol with a subscript, e.g. symbol("T", "a").
TextLine symbol(const std::string& letter, const std::string& subscript);

/// A symbol as the tables write it, with a subscript behind a _ where it has one: "T_a", "β".
TextLine symbol(std::string_view written);

/// `a` followed by `b`.
TextLine operator+(TextLine a, const TextLine& b);
TextLine operator+(TextLine a, const std::string& upright);

enum class Align { left, centre, right };

/// Sets text in the embedded typeface at any size.
class TextPainter {
 public:
  TextPainter();
  ~TextPainter();
  TextPainter(const TextPainter&) = delete;
  TextPainter& operator=(const TextPainter&) = delete;

  /// Width of `line` in pixels; `size` is the em in pixels.
  double width(const TextLine& line, double size);

  /// Draws `line` with its baseline at height `y`, to the right of, around or to the left of `x`.
  void draw(io::Image& image, double x, double y, const TextLine& line, double size, Rgb color,
            Align align = Align::left);

  /// The same, turned a quarter counter-clockwise: reads upwards, its baseline at the column `x`
  /// and its middle at height `y`.
  void draw_upwards(io::Image& image, double x, double y, const TextLine& line, double size,
                    Rgb color);

 private:
  struct FreeType;
  std::unique_ptr<FreeType> freetype_;
};

}  // namespace pupflow::view
