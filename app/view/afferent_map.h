// Flat maps of a pup's skin: the faces of the cube that it is made from, unrolled to a cross, and a
// disc as the pup itself looks ahead. Knows no OpenGL.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "pupflow/view.h"

namespace pupflow::view {

/// A face of the cross, whose unit is the edge of a face: x to the right from its left end, y down
/// from its top.
struct CrossFace {
  std::string_view name;  // of the body axis that it looks along
  int x, y;
};

/// The faces in the order of skin_cells (skin.h), seen from outside. Side by side are y < 0, x > 0,
/// y > 0, x < 0; z > 0 is above the second and z < 0 below it.
constexpr std::array<CrossFace, 6> kCross{{{"+x", 1, 1},
                                           {"+y", 2, 1},
                                           {"+z", 1, 0},
                                           {"\u2212x", 3, 1},
                                           {"\u2212y", 0, 1},
                                           {"\u2212z", 1, 2}}};
constexpr int kCrossWidth = 4, kCrossHeight = 3;

/// Where the afferents are on the cross. Their cells are squares with an edge of 1 / `face_points`.
/// Cells that are neighbours on a face, or across an edge that the cross does not cut, are
/// neighbours.
class SkinCross {
 public:
  /// `face_points` >= 1.
  explicit SkinCross(int face_points);

  int face_points() const { return face_points_; }

  /// The upper left corner of each afferent's cell.
  const std::vector<Eigen::Vector2d>& cells() const { return cells_; }

  /// The afferent whose cell holds a place, or -1.
  int afferent(const Eigen::Vector2d& place) const;

 private:
  int face_points_;
  std::vector<Eigen::Vector2d> cells_;
  std::vector<int> grid_;  // afferents, row by row; -1 beside the cross
};

/// How a pup is turned: from body axes, in which it was at rest, to those of the arena. The rotation
/// nearest to the map that fits its points best; none where they are not finite.
Eigen::Matrix3d body_rotation(const LitterView& litter, int pup);

/// The afferent whose cell on the skin at rest holds a direction (body axes, length 1).
int afferent_towards(const Eigen::Vector3d& direction, int face_points);

/// The whole skin on a disc, without distortion of areas (Lambert's azimuthal projection), as the
/// pup looks ahead: in the middle is the direction of travel, at the rim what is behind, on the left
/// the left, at the top what is above. An image: pixel (row, column) is element row * size + column.
class HeadingDisc {
 public:
  /// `face_points` >= 1, `size` >= 1 rows and columns.
  HeadingDisc(int face_points, int size);

  /// The disc of a pup turned by `rotation` that travels in the direction `heading` (radians).
  void update(const Eigen::Matrix3d& rotation, double heading);

  int face_points() const { return face_points_; }
  int size() const { return size_; }

  /// The number of the afferent at each pixel; -1 outside the disc.
  const std::vector<int>& afferents() const { return afferents_; }

 private:
  struct Pixel {
    std::size_t place;
    Eigen::Vector3d direction;  // ahead, right, up
  };
  int face_points_, size_;
  std::vector<Pixel> inside_;
  std::vector<int> afferents_;
};

}  // namespace pupflow::view
