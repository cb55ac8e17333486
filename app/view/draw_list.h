// What there is to draw of a litter, with no word of how.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/view/camera.h"
#include "app/view/color_scale.h"
#include "pupflow/view.h"

namespace pupflow::view {

/// One point of a pup, laid out as it is uploaded.
struct Sphere {
  float x, y, z;  // centre, arena units
  std::uint8_t r, g, b, a;
};
static_assert(sizeof(Sphere) == 16);

/// The rim around the arena, in arena radii: its height above the floor, its depth below it
/// (pressed points sink in a little), and its width outside the arena.
constexpr float kRimHeight = 0.035f, kRimDepth = 0.025f, kRimWidth = 0.03f;

enum class Culling {
  none,
  hidden  // leave out points on the far side of a pup whose skin has no holes
};

/// The arena and the visible points of a litter. Its arrays are reused from frame to frame.
class DrawList {
 public:
  /// Fills the list for a look through `camera`. Each point gets the color of its value of
  /// `scale.field`: its own, or its pup's. The scale is fitted to this litter where the data decides
  /// its ends. Bounds are those of all points, culled or not. With Culling::hidden the list must be
  /// updated when the camera turns or moves.
  void update(const LitterView& litter, const ColorScale& scale, const Camera& camera,
              Culling culling = Culling::hidden);

  std::span<const Sphere> spheres() const { return spheres_; }
  float sphere_radius() const { return sphere_radius_; }
  float arena_radius() const { return arena_radius_; }
  const Bounds& bounds() const { return bounds_; }    // of spheres and arena
  const ColorScale& scale() const { return scale_; }  // of the last update, fitted

 private:
  std::vector<Sphere> spheres_;
  std::vector<float> xyz_;      // of one pup
  std::vector<double> values_;  // of the field that is shown
  ColorScale scale_;
  float sphere_radius_ = 0, arena_radius_ = 0;
  Bounds bounds_;
};

}  // namespace pupflow::view
