// The light that a litter lies in: a key lamp, the sky, what the floor throws back. Bodies and
// floor take light from each other as balls would.
//
// Brightness multiplies a color's sRGB components. It is 1 for open surfaces that face within 35
// degrees of the key lamp, so that their colors can be read off the legend.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pupflow::view {

/// The direction of the key lamp, a unit vector: 60 degrees above the floor.
Eigen::Vector3f key_light();

/// How bright surfaces are. `encoded` light is what multiplies a color.
struct LightModel {
  float key, sky, floor;  // strengths
  float full;             // the light that counts as 1
  float least;            // of it that is always there: hues stay visible
  float low_sky;          // the share of the sky's light that reaches a body's foot
  static constexpr float kGamma = 2.2f;
};
const LightModel& light_model();

/// The outline of a body, as far as its shadow is concerned; world units.
struct Ball {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  float radius = 0;
};

/// How bright the floor is: a picture of size x size texels from (-reach, -reach), rows along y.
/// 255: open floor.
struct FloorLight {
  int size = 0;
  float reach = 0;
  std::vector<std::uint8_t> texels;
};

class Light {
 public:
  /// Light among `balls`, which must outlive it. Each is shaded by its neighbours only; without
  /// `occlusion` by none.
  Light(std::span<const Ball> balls, bool occlusion);

  /// The shares of the sky and of the lamp that neighbours leave.
  struct Left {
    float sky = 1, key = 1;
  };
  Left left(std::size_t own, const Eigen::Vector3f& place, const Eigen::Vector3f& normal) const;

  /// Brightness, in 0 ... 1, at a place with this unit normal on the body `own`.
  float at(std::size_t own, const Eigen::Vector3f& place, const Eigen::Vector3f& normal) const;

  /// Light on a floor with that radius of which one sees no more than `pixel`; world units.
  void on_floor(float arena_radius, float pixel, FloorLight& floor) const;

 private:
  std::span<const Ball> balls_;
  std::vector<std::size_t> first_;  // of each ball's neighbours
  std::vector<int> neighbours_;
};

}  // namespace pupflow::view
