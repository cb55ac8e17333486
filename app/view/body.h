// One pup while it is added to what there is to draw.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "app/view/light.h"
#include "app/view/rgb.h"

namespace pupflow::view {

/// A place and its color, lit, laid out as it is uploaded. `a` is the share that it covers.
struct Vertex {
  float x, y, z;  // arena units
  std::uint8_t r, g, b, a;
};
static_assert(sizeof(Vertex) == 16);

/// The color in a light of this brightness (1: as it is).
inline Vertex lit(const Eigen::Vector3f& place, Rgb color, float brightness,
                  std::uint8_t cover = 255) {
  const auto byte = [&](std::uint8_t c) {
    return static_cast<std::uint8_t>(std::lround(static_cast<float>(c) * brightness));
  };
  return {place.x(), place.y(), place.z(), byte(color.r), byte(color.g), byte(color.b), cover};
}

/// A pup, and how it is looked at.
struct Body {
  std::size_t pup;
  std::span<const float> xyz;
  const Ball& ball;
  Eigen::Vector3f eye, backward;
  bool perspective;
  float pixel;  // edge of a sample at the body, arena units

  std::size_t points() const { return xyz.size() / 3; }
  Eigen::Map<const Eigen::Vector3f> point(std::size_t i) const {
    return Eigen::Map<const Eigen::Vector3f>(&xyz[3 * i]);
  }
  Eigen::Vector3f sight(const Eigen::Vector3f& place) const {
    return perspective ? (eye - place).eval() : backward;
  }
};

}  // namespace pupflow::view
