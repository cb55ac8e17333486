#include "app/view/mark_painter.h"

#include <cmath>

#include "app/view/canvas.h"

namespace pupflow::view {

namespace {

constexpr Rgb kPaper{255, 255, 255};

class Painter {
 public:
  Painter(io::Image& image, TextPainter& text) : image_(image), text_(text) {}

  void operator()(const FlatLine& flat) {
    line(image_, flat.from, flat.to, flat.width, flat.ink.color, flat.ink.opacity);
  }

  void operator()(const FlatFill& flat) {
    fill(image_, flat.corners, flat.ink.color, flat.ink.opacity);
  }

  void operator()(const FlatText& flat) {
    const double away = halo_width(flat.size);
    for (int i = 0; flat.halo && i < 8; ++i) {
      const double angle = i * 0.785398;
      text_.draw(image_, flat.at.x() + away * std::cos(angle), flat.at.y() + away * std::sin(angle),
                 flat.text, flat.size, kPaper, flat.align);
    }
    text_.draw(image_, flat.at.x(), flat.at.y(), flat.text, flat.size, flat.color, flat.align);
  }

 private:
  io::Image& image_;
  TextPainter& text_;
};

}  // namespace

void paint(io::Image& image, TextPainter& text, std::span<const Flat> flats) {
  Painter painter(image, text);
  for (const Flat& flat : flats) std::visit(painter, flat);
}

void paint_marks(io::Image& image, TextPainter& text, const Marks& marks,
                 const Projection& projection) {
  std::vector<Flat> flats;
  flatten(marks, projection, image.height / kMarkRows, flats);
  paint(image, text, flats);
}

}  // namespace pupflow::view
