#include "app/view/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstring>

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

}  // namespace

void blend(io::Image& image, int x, int y, Rgb color, double cover) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  std::uint8_t* pixel = image.pixel(x, y);
  cover = std::clamp(cover, 0.0, 1.0);
  mix(pixel[0], color.r, cover);
  mix(pixel[1], color.g, cover);
  mix(pixel[2], color.b, cover);
  mix(pixel[3], 255, cover);
}

void fill(io::Image& image, const Box& box, Rgb color) {
  const Box inside = clip(image, box);
  for (int y = inside.y; y < inside.y + inside.height; ++y) {
    for (int x = inside.x; x < inside.x + inside.width; ++x) {
      const std::uint8_t rgba[4] = {color.r, color.g, color.b, 255};
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
  if (!(length > 0)) return;
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

void blit(io::Image& image, const io::Image& source, int x, int y) {
  const Box inside = clip(image, {x, y, source.width, source.height});
  for (int row = inside.y; row < inside.y + inside.height && inside.width > 0; ++row) {
    std::memcpy(image.pixel(inside.x, row), source.pixel(inside.x - x, row - y),
                4 * static_cast<std::size_t>(inside.width));
  }
}

}  // namespace pupflow::view
