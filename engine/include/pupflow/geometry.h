// The shape of a pup at rest, the surface through its points, and where the pups start.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "pupflow/parameters.h"

namespace pupflow {

/// n = 6 k^2 points at rest on a sphere of radius `radius` round the origin, face by face: three
/// faces of a cube, then those opposite, so that point n/2 + i is the mirror image of point i
/// through the centre, to the bit. On each face of a cube the points sit at the centres of a k x k
/// grid and go to the sphere by x' = x sqrt(1 - y^2/2 - z^2/2 + y^2 z^2/3) and its cyclic partners.
/// Wilson 2017, Methods.
std::vector<Eigen::Vector3d> cube_sphere(int face_points, double radius);

/// The surface through the points of `cube_sphere(face_points, ...)`: 12 k^2 - 4 triangles of point
/// numbers, counter-clockwise seen from outside. The six k x k grids are joined by a strip of
/// quads (two triangles each) along each of the cube's twelve edges and by one triangle at each of
/// its eight corners, so the surface is closed. `face_points` from 2.
std::vector<std::array<int, 3>> surface_triangles(int face_points);

/// Where the pups' centres start. column (Wilson 2017): pup j at (r_x, r_y, s j + r_pup + r_point),
/// with r_x and r_y uniform within start_spread. The paper's height is r_pup + r_point lower, which
/// would put pup 0 under the floor. Its spacing is 1; s = max(1, 2 (r_pup + r_point)), so that
/// large pups do not begin inside each other. carpet: a jittered hexagonal grid over the arena
/// floor, in as few layers as fit, a little above rest height. Each pup draws from a random stream
/// of its own.
std::vector<Eigen::Vector3d> start_centres(const Params& params);

}  // namespace pupflow
