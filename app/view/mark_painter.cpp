#include "app/view/mark_painter.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace pupflow::view {

namespace {

using Place = Eigen::Vector2d;

constexpr double kRows = 960;  // of the picture that widths and sizes are meant for
constexpr Rgb kPaper{255, 255, 255};
constexpr double kSign = 2.1;  // width of a sign with its gap, in text sizes
constexpr int kPieces = 8;     // of an edge that bodies may hide

class Painter {
 public:
  Painter(io::Image& image, TextPainter& text, const Projection& projection)
      : image_(image), text_(text), projection_(projection), scale_(image.height / kRows) {}

  void operator()(const Segment& segment) {
    stroke(segment.from, segment.to, segment.width, segment.ink);
  }

  void operator()(const Polyline& line) {
    const auto count = static_cast<double>(line.points.size());
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      Ink ink = line.ink;
      if (line.fades) ink.opacity *= static_cast<double>(i) / count;
      stroke(line.points[i - 1], line.points[i], line.width, ink);
    }
  }

  void operator()(const Arrow& arrow) {
    Place from, to;
    if (!projection_.place(arrow.from, from) || !projection_.place(arrow.to, to)) return;
    const double width = std::max(1.0, arrow.width * scale_), length = (to - from).norm();
    if (length < 1e-6) return;
    const Place along = (to - from) / length, across(-along.y(), along.x());
    const double head = std::min(4.5 * width, length);
    line(image_, from, to - 0.7 * head * along, width, arrow.ink.color, arrow.ink.opacity);
    const Place corners[] = {to, to - head * along + 0.45 * head * across,
                             to - head * along - 0.45 * head * across};
    fill(image_, corners, arrow.ink.color, arrow.ink.opacity);
  }

  void operator()(const Label& label) {
    Place at;
    if (!projection_.place(label.at, at)) return;
    const double size = std::max(8.0, label.size * scale_);
    paint_label(image_, text_, at.x(), at.y() + 0.36 * size, label.text, size, label.ink.color,
                Align::centre);
  }

  void operator()(const Polygon& polygon) {
    std::vector<Place> corners;
    for (const Eigen::Vector3d& corner : polygon.corners) {
      if (!projection_.place(corner, corners.emplace_back())) return;
    }
    fill(image_, corners, polygon.inside.color, polygon.inside.opacity);
    const double width = std::max(1.0, polygon.width * scale_);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t next = (i + 1) % corners.size();
      const Eigen::Vector3d along = polygon.corners[next] - polygon.corners[i];
      for (int piece = 0; piece < kPieces; ++piece) {
        const double begin = static_cast<double>(piece) / kPieces, step = 1.0 / kPieces;
        if (projection_.hidden(polygon.corners[i] + (begin + step / 2) * along)) continue;
        const Place way = corners[next] - corners[i];
        line(image_, corners[i] + begin * way, corners[i] + (begin + step) * way, width,
             polygon.outline.color, polygon.outline.opacity);
      }
    }
  }

 private:
  void stroke(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double width, const Ink& ink) {
    Place from, to;
    if (!projection_.place(a, from) || !projection_.place(b, to)) return;
    line(image_, from, to, std::max(1.0, width * scale_), ink.color, ink.opacity);
  }

  io::Image& image_;
  TextPainter& text_;
  const Projection& projection_;
  double scale_;
};

void paint_sign(io::Image& image, TextPainter& text, const LegendEntry& entry, double x, double y,
                double size) {
  const double width = 1.6 * size, middle = y - 0.36 * size, thick = std::max(1.0, 0.14 * size);
  const auto& [color, opacity] = entry.ink;
  switch (entry.sign) {
    case LegendEntry::Sign::line:
      line(image, Place(x, middle), Place(x + width, middle), thick, color, opacity);
      return;
    case LegendEntry::Sign::arrow: {
      line(image, Place(x, middle), Place(x + width - 0.4 * size, middle), thick, color, opacity);
      const Place head[] = {{x + width, middle},
                            {x + width - 0.55 * size, middle - 0.28 * size},
                            {x + width - 0.55 * size, middle + 0.28 * size}};
      fill(image, head, color, opacity);
      return;
    }
    case LegendEntry::Sign::area: {
      const Place corners[] = {{x, middle - 0.4 * size},
                               {x + width, middle - 0.4 * size},
                               {x + width, middle + 0.4 * size},
                               {x, middle + 0.4 * size}};
      fill(image, corners, color, 0.1 * opacity);
      for (std::size_t i = 0; i < 4; ++i) {
        line(image, corners[i], corners[(i + 1) % 4], 0.7 * thick, color, opacity);
      }
      return;
    }
    case LegendEntry::Sign::label:
      text.draw(image, x + width / 2, y, {{"0"}}, size, color, Align::centre);
      return;
  }
}

}  // namespace

void paint_label(io::Image& image, TextPainter& text, double x, double y, const TextLine& line,
                 double size, Rgb color, Align align) {
  const double away = std::max(1.0, 0.09 * size);
  for (int i = 0; i < 8; ++i) {
    const double angle = i * 0.785398;
    text.draw(image, x + away * std::cos(angle), y + away * std::sin(angle), line, size, kPaper,
              align);
  }
  text.draw(image, x, y, line, size, color, align);
}

void paint_marks(io::Image& image, TextPainter& text, const Marks& marks,
                 const Projection& projection) {
  Painter painter(image, text, projection);
  for (const Mark& mark : marks.marks) std::visit(painter, mark);
}

double legend_width(TextPainter& text, const std::vector<LegendEntry>& legend, double size) {
  double width = 0;
  for (const LegendEntry& entry : legend) width = std::max(width, text.width(entry.text, size));
  return width + kSign * size;
}

void paint_legend(io::Image& image, TextPainter& text, const std::vector<LegendEntry>& legend,
                  double x, double y, double size) {
  for (std::size_t i = 0; i < legend.size(); ++i) {
    const double baseline = y + (1 + 1.5 * static_cast<double>(i)) * size;
    paint_sign(image, text, legend[i], x, baseline, size);
    paint_label(image, text, x + kSign * size, baseline, legend[i].text, size, {40, 40, 40});
  }
}

}  // namespace pupflow::view
