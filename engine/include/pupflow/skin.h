/// @file
/// How the afferents (points) of a pup lie on its skin: cells of six grids, neighbours, an image.
#pragma once

#include <vector>

#pragma GCC visibility push(default)
namespace pupflow {

/// The place of an afferent on the cube from which the pup's sphere is made. Faces 0, 1, 2 are
/// those of the body's x, y and z axes, 3, 4, 5 the opposite ones.
struct SkinCell {
  int face;    ///< 0 ... 5
  int row;     ///< 0 ... k - 1
  int column;  ///< 0 ... k - 1
};

/// One cell per afferent of a pup with `face_points` >= 1 points along a face edge.
std::vector<SkinCell> skin_cells(int face_points);

/// For each afferent those that share an edge of `surface_triangles(face_points)` with it,
/// ascending. `face_points` >= 2.
std::vector<std::vector<int>> skin_neighbours(int face_points);

/// An image of the skin: pixel (row, column) is element row * size + column and holds the number of
/// an afferent. Every pixel stands for the same area of the sphere.
struct SkinSheet {
  int size = 0;               ///< rows and columns
  std::vector<int> afferent;  ///< size * size numbers, row by row
};

/// The sheet of a pup: size 8 k, so 32/3 pixels an afferent on average, and every afferent has
/// some. A pixel belongs to the afferent nearest to its middle (of equally near ones the lowest).
/// `face_points` = k >= 1.
///
/// The map from square to sphere is Clarberg's octahedral one (2008, Fast equal-area mapping of the
/// (hemi)sphere using SIMD), with u to the right and v up in [-1, 1]:
///
///   d   = 1 - |u| - |v|
///   r   = 1 - |d|
///   phi = (1 + (|v| - |u|) / r) pi/4
///   z   = sign(d) (1 - r^2)
///   x   = sign(u) cos(phi) r sqrt(2 - r^2)
///   y   = sign(v) sin(phi) r sqrt(2 - r^2)
///
/// in body axes: z in the middle, -z at the four corners.
SkinSheet skin_sheet(int face_points);

}  // namespace pupflow
#pragma GCC visibility pop
