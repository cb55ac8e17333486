/// @file
/// The shape of a pup at rest, the surface through its points, and the centres of pups at the start.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "pupflow/parameters.h"

#pragma GCC visibility push(default)
namespace pupflow {

/// n = 6 k^2 points on a sphere of radius `radius` > 0 round the origin, face by face: three faces
/// of a cube, then the opposite ones, so that point n/2 + i is minus point i, to the bit. k =
/// `face_points` >= 1. On each face of the cube the points are at the centres of a k x k grid and
/// are mapped to the sphere by
///
///   x' = x sqrt(1 - y^2/2 - z^2/2 + y^2 z^2/3)
///   y' = y sqrt(1 - z^2/2 - x^2/2 + z^2 x^2/3)
///   z' = z sqrt(1 - x^2/2 - y^2/2 + x^2 y^2/3)
///
/// Wilson 2017, Methods.
std::vector<Eigen::Vector3d> cube_sphere(int face_points, double radius);

/// The closed surface through the points of `cube_sphere(face_points, ...)`: 12 k^2 - 4 triangles
/// of point numbers, counter-clockwise seen from outside. A strip of quads (two triangles each)
/// along each of the cube's twelve edges and one triangle at each of its eight corners join the six
/// k x k grids. `face_points` >= 2.
std::vector<std::array<int, 3>> surface_triangles(int face_points);

/// The pups' centres at t = 0, one per pup.
///
/// column (Wilson 2017): the centre of pup j = 0, 1, ... is
///
///   (r_x, r_y, s j + r_pup + r_point),    s = max(1, 2 (r_pup + r_point))
///
/// with r_x and r_y uniform within +-start_spread. The paper's height is r_pup + r_point lower, so
/// that pup 0 would be under the floor. The paper's spacing is s = 1; with it large pups would
/// start inside each other.
///
/// carpet: a hexagonal grid with random displacements over the arena floor, in as few layers as
/// fit, slightly above rest height.
///
/// Each pup has a random stream of its own. `params` must be sound (`check`).
std::vector<Eigen::Vector3d> start_centres(const Params& params);

}  // namespace pupflow
#pragma GCC visibility pop
