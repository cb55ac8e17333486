// A small body as one ellipsoid: what is left of its shape, color and light a dozen pixels across.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "app/view/light.h"
#include "app/view/rgb.h"

namespace pupflow::view {

/// Laid out as it is uploaded. The surface is centre + S u for all unit vectors u, with a symmetric
/// matrix S = {xx, yy, zz, xy, xz, yz}; world units. Light is that which neighbours leave on the
/// sides that face along x, y, z and against x, y, z; 255: all of it.
struct Ellipsoid {
  float centre[3];
  float shape[6];
  std::uint8_t color[4];
  std::uint8_t sky[2][4], key[2][4];  // along, against; the fourth is unused
  float radius;                       // of the body's ball
};
static_assert(sizeof(Ellipsoid) == 60);

/// S of points around `centre` whose surface is one point radius further out: a sphere of evenly
/// spread points, however it is stretched, keeps its axes.
Eigen::Matrix3f ellipsoid_shape(const Eigen::Map<const Eigen::Matrix3Xf>& points,
                                const Eigen::Vector3f& centre, float point_radius);

/// The body `own` of `light`.
Ellipsoid ellipsoid(const Ball& ball, const Eigen::Matrix3f& shape, Rgb color, std::size_t own,
                    const Light& light);

}  // namespace pupflow::view
