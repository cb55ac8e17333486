#include "app/view/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace pupflow::view {

namespace {

Box clip(const io::Image& image, const Box& box) {
  const int left = std::max(box.x, 0), top = std::max(box.y, 0);
  const int right = std::min(box.x + box.width, image.width);
  const int bottom = std::min(box.y + box.height, image.height);
  return {left, top, std::max(right - left, 0), std::max(bottom - top, 0)};
}

void mix(std::uint8_t& below, std::uint8_t above, double cover) {
  below = static_cast<std::uint8_t>(std::lround(below + cover * (above - below)));
}

/// Further off nothing is drawn: coordinates of pixels are whole numbers of 32 bits.
constexpr double kFurthestPixel = 1e9;

bool is_near(double coordinate) {
  return std::abs(coordinate) < kFurthestPixel;
}

/// `coordinate` as one of pixels from 0 to `end`; 0 for NaN.
int within(double coordinate, int end) {
  return static_cast<int>(std::min<double>(std::max(0.0, coordinate), end));
}

}  // namespace

void blend(io::Image& image, int x, int y, Rgb color, double cover) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  std::uint8_t* pixel = image.pixel(x, y);
  cover = std::clamp(cover, 0.0, 1.0);
  // Where the picture is transparent, its own color counts the less.
  const double below = pixel[3] / 255.0 * (1 - cover), all = below + cover;
  if (!(all > 0)) return;
  mix(pixel[0], color.r, cover / all);
  mix(pixel[1], color.g, cover / all);
  mix(pixel[2], color.b, cover / all);
  mix(pixel[3], 255, cover);
}

void fill(io::Image& image, const Box& box, Rgb color, std::uint8_t alpha) {
  const Box inside = clip(image, box);
  for (int y = inside.y; y < inside.y + inside.height; ++y) {
    for (int x = inside.x; x < inside.x + inside.width; ++x) {
      const std::uint8_t rgba[4] = {color.r, color.g, color.b, alpha};
      std::memcpy(image.pixel(x, y), rgba, 4);
    }
  }
}

void frame(io::Image& image, const Box& box, int width, Rgb color) {
  fill(image, {box.x, box.y, box.width, width}, color);
  fill(image, {box.x, box.y + box.height - width, box.width, width}, color);
  fill(image, {box.x, box.y, width, box.height}, color);
  fill(image, {box.x + box.width - width, box.y, width, box.height}, color);
}

void line(io::Image& image, double x0, double y0, double x1, double y1, double width, Rgb color) {
  const double dx = x1 - x0, dy = y1 - y0, length = std::hypot(dx, dy), half = width / 2;
  if (!(length > 0 && length < kFurthestPixel) || !is_near(x0) || !is_near(y0)) return;
  const Box reach = clip(image, {static_cast<int>(std::floor(std::min(x0, x1) - half - 1)),
                                 static_cast<int>(std::floor(std::min(y0, y1) - half - 1)),
                                 static_cast<int>(std::abs(dx) + width + 4),
                                 static_cast<int>(std::abs(dy) + width + 4)});
  for (int y = reach.y; y < reach.y + reach.height; ++y) {
    for (int x = reach.x; x < reach.x + reach.width; ++x) {
      const double px = x + 0.5 - x0, py = y + 0.5 - y0;
      const double along = (px * dx + py * dy) / length, across = (py * dx - px * dy) / length;
      const double cover_across = std::clamp(half - std::abs(across) + 0.5, 0.0, 1.0);
      const double cover_along = std::clamp(std::min(along, length - along) + 0.5, 0.0, 1.0);
      blend(image, x, y, color, std::min(cover_across, width) * cover_along);
    }
  }
}

void line(io::Image& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width,
          Rgb color, double opacity) {
  const double half = width / 2, margin = half + 1;
  const Eigen::Vector2d along = to - from;
  if (!along.allFinite()) return;
  const double length2 = std::max(along.squaredNorm(), 1e-12);
  const Eigen::Vector2d low = from.cwiseMin(to), high = from.cwiseMax(to);
  const int top = within(std::floor(low.y() - margin), image.height);
  const int bottom = within(std::ceil(high.y() + margin), image.height);
  for (int y = top; y < bottom; ++y) {
    // The stretch of the line near this row.
    double begin = low.x(), end = high.x();
    if (std::abs(along.y()) > 1e-9) {
      const auto x_at = [&](double row) {
        return from.x() + along.x() * std::clamp((row - from.y()) / along.y(), 0.0, 1.0);
      };
      begin = std::min(x_at(y - margin), x_at(y + 1 + margin));
      end = std::max(x_at(y - margin), x_at(y + 1 + margin));
    }
    const int left = within(std::floor(begin - margin), image.width);
    const int right = within(std::ceil(end + margin), image.width);
    for (int x = left; x < right; ++x) {
      const Eigen::Vector2d place(x + 0.5, y + 0.5);
      const double share = std::clamp((place - from).dot(along) / length2, 0.0, 1.0);
      const double cover = half + 0.5 - (place - from - share * along).norm();
      if (cover > 0) blend(image, x, y, color, opacity * std::min(cover, 1.0));
    }
  }
}

void fill(io::Image& image, std::span<const Eigen::Vector2d> corners, Rgb color, double opacity) {
  constexpr int kRows = 4;  // samples of a pixel's height
  if (corners.size() < 3) return;
  double low = corners[0].y(), high = low;
  for (const Eigen::Vector2d& corner : corners) {
    low = std::min(low, corner.y());
    high = std::max(high, corner.y());
  }
  const int top = within(std::floor(low), image.height);
  const int bottom = within(std::ceil(high), image.height);
  std::vector<double> cover(static_cast<std::size_t>(image.width));
  std::vector<double> crossings;
  for (int y = top; y < bottom; ++y) {
    std::ranges::fill(cover, 0);
    for (int sample = 0; sample < kRows; ++sample) {
      const double row = y + (sample + 0.5) / kRows;
      crossings.clear();
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if ((a.y() <= row) == (b.y() <= row)) continue;
        crossings.push_back(a.x() + (row - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
      }
      std::ranges::sort(crossings);
      for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        const double begin = std::min<double>(image.width, std::max(0.0, crossings[i]));
        const double end = std::min<double>(image.width, crossings[i + 1]);
        for (int x = static_cast<int>(begin); x < std::ceil(end); ++x) {
          const double part = std::min(end, x + 1.0) - std::max(begin, static_cast<double>(x));
          cover[static_cast<std::size_t>(x)] += part / kRows;
        }
      }
    }
    for (int x = 0; x < image.width; ++x) {
      const double share = cover[static_cast<std::size_t>(x)];
      if (share > 0) blend(image, x, y, color, opacity * share);
    }
  }
}

void blit(io::Image& image, const io::Image& source, int x, int y) {
  const Box inside = clip(image, {x, y, source.width, source.height});
  for (int row = inside.y; row < inside.y + inside.height && inside.width > 0; ++row) {
    std::memcpy(image.pixel(inside.x, row), source.pixel(inside.x - x, row - y),
                4 * static_cast<std::size_t>(inside.width));
  }
}

}  // namespace pupflow::view
