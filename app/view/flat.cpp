#include "app/view/flat.h"

#include <algorithm>
#include <string>

namespace pupflow::view {

namespace {

using Place = Eigen::Vector2d;

constexpr double kSign = 2.1;  // width of a sign with its gap, in text sizes
constexpr int kPieces = 8;     // of an edge that bodies may hide

class Flattener {
 public:
  Flattener(const Projection& projection, double scale, std::vector<Flat>& flats)
      : projection_(projection), scale_(scale), flats_(flats) {}

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
    const double width = thick(arrow.width), length = (to - from).norm();
    if (length < 1e-6) return;
    const Place along = (to - from) / length, across(-along.y(), along.x());
    const double head = std::min(4.5 * width, length);
    flats_.emplace_back(FlatLine{from, to - 0.7 * head * along, width, arrow.ink});
    flats_.emplace_back(FlatFill{
        {to, to - head * along + 0.45 * head * across, to - head * along - 0.45 * head * across},
        arrow.ink});
  }

  void operator()(const Label& label) {
    Place at;
    if (!projection_.place(label.at, at)) return;
    const double size = std::max(8.0, label.size * scale_);
    flats_.emplace_back(
        FlatText{{at.x(), at.y() + 0.36 * size}, label.text, size, label.ink.color, Align::centre});
  }

  void operator()(const Polygon& polygon) {
    std::vector<Place> corners;
    for (const Eigen::Vector3d& corner : polygon.corners) {
      if (!projection_.place(corner, corners.emplace_back())) return;
    }
    flats_.emplace_back(FlatFill{corners, polygon.inside});
    const double width = thick(polygon.width);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t next = (i + 1) % corners.size();
      const Eigen::Vector3d along = polygon.corners[next] - polygon.corners[i];
      const Place way = corners[next] - corners[i];
      for (int piece = 0; piece < kPieces; ++piece) {
        const double begin = static_cast<double>(piece) / kPieces, step = 1.0 / kPieces;
        if (projection_.hidden(polygon.corners[i] + (begin + step / 2) * along)) continue;
        flats_.emplace_back(FlatLine{corners[i] + begin * way, corners[i] + (begin + step) * way,
                                     width, polygon.outline});
      }
    }
  }

 private:
  double thick(double width) const { return std::max(1.0, width * scale_); }

  void stroke(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double width, const Ink& ink) {
    Place from, to;
    if (!projection_.place(a, from) || !projection_.place(b, to)) return;
    flats_.emplace_back(FlatLine{from, to, thick(width), ink});
  }

  const Projection& projection_;
  double scale_;
  std::vector<Flat>& flats_;
};

void add_sign(const LegendEntry& entry, double x, double y, double size, std::vector<Flat>& flats) {
  const double width = 1.6 * size, middle = y - 0.36 * size, thick = std::max(1.0, 0.14 * size);
  const Ink& ink = entry.ink;
  switch (entry.sign) {
    case LegendEntry::Sign::line:
      flats.emplace_back(FlatLine{{x, middle}, {x + width, middle}, thick, ink});
      return;
    case LegendEntry::Sign::arrow:
      flats.emplace_back(FlatLine{{x, middle}, {x + width - 0.4 * size, middle}, thick, ink});
      flats.emplace_back(FlatFill{{{x + width, middle},
                                   {x + width - 0.55 * size, middle - 0.28 * size},
                                   {x + width - 0.55 * size, middle + 0.28 * size}},
                                  ink});
      return;
    case LegendEntry::Sign::area: {
      const std::vector<Place> corners{{x, middle - 0.4 * size},
                                       {x + width, middle - 0.4 * size},
                                       {x + width, middle + 0.4 * size},
                                       {x, middle + 0.4 * size}};
      flats.emplace_back(FlatFill{corners, {ink.color, 0.1 * ink.opacity}});
      for (std::size_t i = 0; i < 4; ++i) {
        flats.emplace_back(FlatLine{corners[i], corners[(i + 1) % 4], 0.7 * thick, ink});
      }
      return;
    }
    case LegendEntry::Sign::label:
      flats.emplace_back(
          FlatText{{x + width / 2, y}, {{"0"}}, size, ink.color, Align::centre, false});
      return;
  }
}

}  // namespace

void flatten(const Marks& marks, const Projection& projection, double scale,
             std::vector<Flat>& flats) {
  Flattener flattener(projection, scale, flats);
  for (const Mark& mark : marks.marks) std::visit(flattener, mark);
}

double legend_width(const TextWidth& width_of, const std::vector<LegendEntry>& legend,
                    double size) {
  double width = 0;
  for (const LegendEntry& entry : legend) width = std::max(width, width_of(entry.text, size));
  return width + kSign * size;
}

void flatten_legend(const std::vector<LegendEntry>& legend, double x, double y, double size,
                    std::vector<Flat>& flats) {
  for (std::size_t i = 0; i < legend.size(); ++i) {
    const double baseline = y + (1 + 1.5 * static_cast<double>(i)) * size;
    add_sign(legend[i], x, baseline, size, flats);
    flats.emplace_back(FlatText{{x + kSign * size, baseline}, legend[i].text, size, {40, 40, 40}});
  }
}

}  // namespace pupflow::view
