// Placing the bodies of pups, and measuring their shape and motion. For tests and reports: no stage
// of a step uses it.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "pupflow/simulation.h"

namespace pupflow {

/// One 3-vector for each point of a pup, or of several pups one after the other.
using Points = std::vector<Eigen::Vector3d>;

/// x0 y0 z0 x1 ..., and back.
std::vector<double> to_numbers(const Points& points);
Points to_points(std::span<const double> xyz);

/// The vectors of one pup, or of all pups: of `view.positions` or `view.velocities`.
Points of_pup(const PointVectors& vectors, int pup);
Points of_all(const PointVectors& vectors);

/// The points of a pup at rest, relative to its centre, turned by `rotation`.
Points rest_points(const Params& params,
                   const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity());

/// `points` moved by `shift`.
Points shifted(Points points, const Eigen::Vector3d& shift);

/// Sets the points and velocities of a pup. Throws what Simulation::set_cloud throws.
void place(Simulation& simulation, int pup, const Points& points, const Points& velocities);

/// The same with one velocity for all points.
void place(Simulation& simulation, int pup, const Points& points,
           const Eigen::Vector3d& velocity = {0, 0, 0});

/// The default parameters for one pup without gravity and drive, far from floor and wall.
Params weightless_pup();

/// What fits the points of a pup best. With the points x_i, the rest offsets q_i and n points:
///
///   c = sum x_i / n
///   F = sum (x_i - c) q_i^T / sum q_ix^2      (sum q_i q_i^T is a multiple of the identity)
///   R = nearest_rotation(F)
struct Pose {
  Eigen::Vector3d centre;    // c
  Eigen::Matrix3d map;       // F, the fitted linear map
  Eigen::Matrix3d rotation;  // R
  double energy = 0;         // deformation energy: sum |x_i - c - R q_i|^2 / (n r_pup^2)
};

/// `rest` holds the rest offsets of the same pup, of which there must be as many.
Pose pose_of(const Points& points, const Points& rest);

}  // namespace pupflow
