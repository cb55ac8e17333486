// Plain drawing into a picture in memory.
#pragma once

#include <Eigen/Core>
#include <span>

#include "app/io/png.h"
#include "app/view/colormap.h"

namespace pupflow::view {

/// A rectangle in pixels, from its upper left corner; parts outside a picture are left out.
struct Box {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Mixes `color` over the pixel (x, y) with `cover` in 0 ... 1; outside the picture, nothing.
void blend(io::Image& image, int x, int y, Rgb color, double cover);

/// Fills `box` with a color, opaque unless told otherwise.
void fill(io::Image& image, const Box& box, Rgb color, std::uint8_t alpha = 255);

/// Draws a frame of `width` pixels just inside `box`.
void frame(io::Image& image, const Box& box, int width, Rgb color);

/// A line between two places, in pixels from the upper left corner of the picture, anti-aliased.
void line(io::Image& image, double x0, double y0, double x1, double y1, double width, Rgb color);

/// The same with an opacity and round ends; a point where both ends are one.
void line(io::Image& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width,
          Rgb color, double opacity);

/// Fills a polygon (even-odd), anti-aliased.
void fill(io::Image& image, std::span<const Eigen::Vector2d> corners, Rgb color, double opacity);

/// Copies `source` with its upper left corner at (x, y).
void blit(io::Image& image, const io::Image& source, int x, int y);

}  // namespace pupflow::view
