// Colors as usual eyes and as eyes that lack a kind of cone see them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "app/view/rgb.h"

namespace pupflow::test {

enum class Vision { usual, protanopia, deuteranopia, tritanopia };
inline constexpr std::array kVisions{Vision::usual, Vision::protanopia, Vision::deuteranopia,
                                     Vision::tritanopia};

/// CIE Lab (D65) of a color as that eye sees it, by the matrices of Machado, Oliveira & Fernandes
/// (2009) for a whole lack, which act on linear RGB.
inline Eigen::Vector3d lab(view::Rgb color, Vision vision = Vision::usual) {
  const auto linear = [](std::uint8_t byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  Eigen::Matrix3d eye = Eigen::Matrix3d::Identity();
  if (vision == Vision::protanopia) {
    eye << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
        1.051998;
  } else if (vision == Vision::deuteranopia) {
    eye << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
        0.968881;
  } else if (vision == Vision::tritanopia) {
    eye << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
        0.303900;
  }
  Eigen::Matrix3d xyz_from_rgb;
  xyz_from_rgb << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339,
      0.1191920, 0.9503041;
  const Eigen::Vector3d rgb(linear(color.r), linear(color.g), linear(color.b));
  const Eigen::Vector3d xyz = xyz_from_rgb * (eye * rgb).cwiseMax(0).cwiseMin(1);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f(xyz.x() / 0.95047), y = f(xyz.y()), z = f(xyz.z() / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// How different two colors look (CIE 1976).
inline double difference(view::Rgb a, view::Rgb b, Vision vision = Vision::usual) {
  return (lab(a, vision) - lab(b, vision)).norm();
}

}  // namespace pupflow::test
