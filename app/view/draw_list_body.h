// What the files of DrawList share.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

#include "app/view/draw_list.h"

namespace pupflow::view {

inline Vertex lit(const Eigen::Vector3f& place, Rgb color, float brightness,
                  std::uint8_t cover = 255) {
  const auto byte = [&](std::uint8_t c) {
    return static_cast<std::uint8_t>(std::lround(static_cast<float>(c) * brightness));
  };
  return {place.x(), place.y(), place.z(), byte(color.r), byte(color.g), byte(color.b), cover};
}

struct DrawList::Body {
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
